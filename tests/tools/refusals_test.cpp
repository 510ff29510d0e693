// SPDX-License-Identifier: MIT
// Words that no command can follow: status 2, one line on standard error that names them, and nothing
// written.
#include "tools/gloam.hpp"

namespace gloam::test::refusals_test {

class Refusals : public InFolder {
  protected:
    // Runs rows of words, with | between rows, each behind `before`. What the error names stands in brackets,
    // or behind =>. {} is an output, which does not come to be; '' is an empty word.
    void expect(const std::string& before, std::string rows) const {
        std::ranges::replace(rows, '\n', ' ');
        for (std::size_t begin = 0; begin < rows.size();) {
            const std::size_t end = std::min(rows.find(" | ", begin), rows.size());
            std::string row = before + rows.substr(begin, end - begin);
            begin = end + 3;
            SCOPED_TRACE(row);
            const std::size_t arrow = std::min(row.find("=> "), row.size());
            std::string named = row.substr(std::min(arrow + 3, row.size()));
            if (named.empty()) named = row.substr(row.find('[') + 1, row.find(']') - row.find('[') - 1);
            row.resize(arrow);
            std::erase_if(row, [](char c) { return c == '[' || c == ']'; });
            std::vector<std::string> all = words(row);
            std::erase(all, "");
            std::ranges::replace(all, "''", "");
            std::ranges::replace(all, "{}", path("out").string());
            expect_could_not_run(run_command(all), named);
            EXPECT_FALSE(fs::exists(path("out")));
        }
    }
};

TEST_F(Refusals, NameUnknownCommandsAndOptions) {
    expect("", R"([no-such-command] | [chek] => chek (gloam --help tells more) | [--no-such-option] |
        explain => (gloam explain --help tells more) | pack gloam/geometry/background.glsl [--no-such-option] |
        report [--no-such-option] x | demo [--no-such-option] | devices [--no-such-option] |
        list [--no-such-option] | check [--no-such-option] | render corner [--no-such-option] |
        stress [--no-such-option])");
}

// Whatever option is added: an empty text, NaN and a count below zero are no values.
TEST_F(Refusals, NameValuesThatNobodyMeans) {
    expect("check ",
           R"([--timeout] nan | [--timeout] NaN | [--timeout] '' | [--timeout] 0 | [--timeout] soon |
        [--jobs] 0 | [--jobs] -1 | [--seed] '' | [--seed] -1 | [--shard] '' | [--inputs] -1 | [--inputs] 0 |
        [--json] '')");
    expect("", R"(bench [--error] nan | bench [--error] 0 | bench [--samples] -4 | bench [--samples] 0 |
        bench temporal [--frames] 0 | render [--radius] '' | render [--radius] nan | render [--out] '' |
        render [--bias] -nan | render moving [--frames] 10000 | stress [--seed] -1 | stress [--frames] 0 |
        pack [--version] '' | demo [--out] '')");
}

TEST_F(Refusals, NameOptionsThatNeedAnotherOrExcludeIt) {
    expect("", R"(render corner [--truth-rays] 64 | render corner [--truth-falloff] step |
        render corner [--truth-thickness] 1 | render moving [--truth-every] | bench [--fail-if-worse] |
        bench --resume => --out | bench --temporal [--single] | bench [--from] a.json --scene corner |
        check --resume => --json | check [--in-process] --jobs 2 | pack --preset fast => --effect |
        pack gloam/sampling/halton.glsl --npm {} => file excludes --npm |
        pack --effect --npm {} => --effect excludes --npm)");
}

TEST_F(Refusals, OfCheckAndExplain) {
    expect("", R"(check [no-such-equation] | check [no_such.glsl] | check HALTON --device [no-such-device] |
        check HALTON --variant [no-such-variant] | check HALTON --inputs [many] |
        check HALTON --json [/no/such/folder/a.json] | check [--in-process]=maybe | check [--range] p=0:1 |
        explain [no_such.glsl] f 1 | explain gloam_falloff_* 1 2 => expected one | devices [--driver])");
    expect("check gloam_radical_* [--shard] ", "2/2 | 1 | a/b | 1/ | /2 | -1/2 | 0/0 | 1/2/3");
}

TEST_F(Refusals, OfListReportDemoSiteAndStress) {
    expect("", R"(list [no-such-kind] | list no-such-kind => equations | list presets [no-such] |
        list methods [--html] {} | list equations --html [/no/such/a.html] | report => file |
        demo --out [/proc/gloam] | site {} [NO-SUCH] --no-pictures | site {} [--inputs] 0 |
        site {} --address example.org --no-pictures => "example.org": expected an address like |
        site {} --method [no_such] --no-pictures | site [/dev/null] --no-pictures |
        stress --only [no-such-run] | stress --only no-such-run => long-run, poison |
        stress --only worst-inputs --equation [no-such] | stress --device [no-such-device] |
        stress --json [/no/such/folder]/stress.json)");
}

TEST_F(Refusals, OfPack) {
    expect("pack ", "[gloam/no/such.glsl] | --npm [/proc/npm] | --version 300es " GLOAM_GLSL_DIR
                    "/passes/study/[reproject.comp]");
    expect("pack gloam/sampling/halton.glsl ", R"(--function [gloam_halton_4d] | --version [110] |
        --target cg => expected hlsl or msl | --target hlsl [--version] 330 | [--lines] --target hlsl |
        --out [/no/such/folder/file] | --out [/dev/full])");
    expect("pack", " => --effect |  --effect => --out");
    expect("pack --effect --out {} ", R"(--preset [magic] |
        --preset tssao-paper => gloam pack gloam/methods/hemisphere.glsl | --normals [magic] |
        --version 310es => 300es | [--version 110] | [--target] hlsl |
        --bent-normals --version 330 => 450 or 430 | --set [samples]=0)");
    expect("pack --effect --out [/dev/null]/effect", " ");
}

TEST_F(Refusals, OfRender) {
    expect("render --out {} ", R"(=> corner | [no-such-scene] | no-such-scene => corner |
        moving [--truth-every] | --gbuffer none [--frame] 2 | --gbuffer [/no/such/folder])");
    expect("render corner --out {} ", R"(--method [no-such-method] | --preset [no-such-preset] |
        --device [no-such-device] | --size [0x0] | --size [99999x99999] | --size [16] | --size [-1x5] |
        --size [16x9x3] | --size [16x] | --radius [0] | --[radius] nan | --bias [-1] | [--samples] 0 |
        --guard -0.1 => guard | --guard 0.6 => guard | --guard nan => guard | [--frames] 0 | [--frame] -1 |
        [--antialias] 9 | --up z => camera of its own | --light [noon] |
        --bent-normals [--bent-interleave] 9 | [--bent-interleave] 4 |
        --preset fast,quality --method gtao,hbao => several of one of the two |
        --preset fast,fast => fast: expected each once | --method gtao,gtao => gtao: expected each once |
        --method gtao,[no-such-method] | --method gtao,hbao [--write-gbuffer] g |
        --set samples => NAME=VALUE | --set [no_such]=1 |
        --set samples=0 => samples 0: expected a whole number, 1 to 2048 |
        --set taps=all => nearest, bilinear or validated | --set guard=1 => guard 1: expected 0 to 0.5 |
        --set radius=1 => --radius | --set method=disc => --method | --truth --truth-rays 0 => 0 rays |
        --truth --truth-falloff [cubic] | --truth [--truth-thickness] 0 | --truth [missing.pfm])");
}

TEST_F(Refusals, OfBench) {
    expect("bench ", R"(--scene [nowhere] --out {} | --method [magic] | --preset [magic] |
        --method gtao gtao => twice | --repeat -1 => --rounds | [--size 8x8] | [--budget 3s] |
        --from [/no/such.json] | --json [/no/such/folder]/a.json | --out [/proc/out] | [nowhere.json])");
    expect("bench methods ", R"(--case [nowhere] | --method [magic] | [--size 1x1] |
        --frames 1 => plane 0: 1 frames, expected 2 or more | --json [/no/such/folder]/a.json |
        --page [/no/such/page.md])");
    expect("bench temporal ", R"(--case [nowhere] | [--size 8x8] | --frames 4 --scored 5 => 5 scored |
        --json [/no/such/folder]/a.json)");
    expect("bench passes ", R"(--size [8x8] | [--rounds] -1 | --half unseen => unseen half |
        --case magic => case magic: expected fresh)");
    expect("bench views ", "=> --single, --sequence | --single [magic]");
    expect("bench views --single fast ", R"(--view magic => case magic | --half [magic] | --set [magic]=1 |
        --view bunny --meshes /nowhere => /nowhere/bunny.obj | --frames 2 --scored 3 => 3 scored frames)");
    expect("bench front ", R"(--plain 9 => 9: expected SLICESxSTEPS+BLURS | --method [magic] |
        --plain 9x65 => expected SLICESxSTEPS | --view room --sequence fast,[magic]=1 |
        --view plan => no perspective view | --single tssao-paper,method=[magic])");
    expect("bench sources ", R"(--scene [releif] | --page [/no/such.md] |
        --rays 0 => enough_samples: expected rays)");
}

}  // namespace gloam::test::refusals_test
