# SPDX-License-Identifier: MIT
"""The faults that a GLSL text can be given, by place."""
import re

OPERATORS = {"<": ["<=", ">"], "<=": ["<", ">="], ">": [">=", "<"], ">=": [">", "<="], "==": ["!="], "!=": ["=="],
             "+": ["-"], "-": ["+"], "*": ["/"], "/": ["*"], "%": ["/"], "<<": [">>"], ">>": ["<<"], "&": ["|"],
             "|": ["&"], "^": ["|"], "&&": ["||"], "||": ["&&"], "+=": ["-="], "-=": ["+="], "*=": ["/="],
             "/=": ["*="], "|=": ["&="], "&=": ["|="], "^=": ["|="], "++": ["--"], "--": ["++"], "!": [""], "~": [""]}
WORDS = {"min": ["max"], "max": ["min"], "sin": ["cos"], "cos": ["sin"], "floor": ["ceil"], "ceil": ["floor"],
         "abs": [""], "sqrt": [""], "normalize": [""], "sign": [""], "any": ["all"], "all": ["any"],
         "lessThan": ["lessThanEqual"], "greaterThan": ["greaterThanEqual"], "true": ["false"], "false": ["true"],
         "round": ["floor"], "roundEven": ["floor"], "isnan": ["isinf"], "isinf": ["isnan"]}
TOKEN = re.compile(r"//[^\n]*|/\*.*?\*/|^[ \t]*#(?:[^\n\\]|\\.|\\\n)*|[A-Za-z_]\w*"
                   r"|0[xX][0-9a-fA-F]+[uU]?|(?:\d+\.\d*|\.\d+|\d+)(?:[eE][+-]?\d+)?[fFuU]?"
                   r"|<<=|>>=|<<|>>|<=|>=|==|!=|&&|\|\||\^\^|\+\+|--|[-+*/%&|^]=|\S", re.M | re.S)


def bare(text):
    """The text with blanks in the place of comments."""
    return re.sub(r"//[^\n]*|/\*.*?\*/", lambda found: re.sub(r"[^\n]", " ", found[0]), text, flags=re.S)


def numbers(text):
    if re.fullmatch(r"0[xX].*", text):
        return [hex(int(text.rstrip("uU"), 16) ^ 1) + ("u" if text[-1] in "uU" else "")]
    value = float(text.rstrip("fFuU"))
    if not re.search(r"[.eE]", text):
        suffix = "u" if text[-1] in "uU" else ""
        return [f"{int(value) + step}{suffix}" for step in (1, -1) if value + step >= 0]
    if value == 0.0:
        return ["1.0"]
    return ["0.0", "2.0"] if value == 1.0 else [repr(2.0 * value), repr(0.5 * value)]


def swizzles(text):
    if len(text) == 1:
        return [other for other in "xy" if other != text]
    turned = [text[::-1], text[1] + text[0] + text[2:], text[0] * len(text)]
    return [other for other in dict.fromkeys(turned) if other != text]


def members_like(name, text):
    """The other members of the structs of a text that have a member of this name, of its type."""
    found = []
    for _, body in re.findall(r"\bstruct\s+(\w+)\s*\{([^}]*)\}", bare(text)):
        members = [(kind, one.strip()) for kind, names in re.findall(r"(\w+)\s+([\w\s,]+);", body)
                   for one in names.split(",")]
        kinds = {kind for kind, one in members if one == name}
        found += [one for kind, one in members if kind in kinds and one != name]
    return list(dict.fromkeys(found))


def end_of(tokens, i, closing):
    """The index of the token that closes what the one at i opens."""
    depth = 0
    for k in range(i, len(tokens)):
        depth += tokens[k][1] in "([{"
        depth -= tokens[k][1] in ")]}"
        if depth == 0 and tokens[k][1] in closing:
            return k
    return None


def condition_before(tokens, i):
    """The index at which the condition of the ? at i begins."""
    depth = 0
    for k in range(i - 1, -1, -1):
        depth += tokens[k][1] in ")]"
        depth -= tokens[k][1] in "(["
        if depth < 0 or (depth == 0 and tokens[k][1] in ("=", "return", ",", ";", "{", "}", "?", ":", "+=", "-=")):
            return k + 1
    return 0


def statement_at(tokens, i):
    """The end of an assignment, a call, a continue or a break at i; None for other statements."""
    name = tokens[i][1]
    if not re.match(r"[A-Za-z_]", name) or name in ("return", "if", "for", "while", "else", "do", "const", "precise"):
        return None
    after = tokens[i + 1][1] if i + 1 < len(tokens) else ""
    if re.match(r"[A-Za-z_]", after):  # a declaration
        return None
    return end_of(tokens, i, ";")


def faults_at(tokens, i, text):
    """What the token at i may become: pairs of an end and a replacement."""
    start, token = tokens[i]
    before = tokens[i - 1][1] if i else ""
    after = tokens[i + 1][1] if i + 1 < len(tokens) else ""
    end = start + len(token)
    found = []
    if before == "." and re.fullmatch("[xyzw]{1,4}", token):
        found += [(end, one) for one in swizzles(token)]
    elif before == "." and re.match(r"[A-Za-z_]", token) and after != "(":
        found += [(end, one) for one in members_like(token, text)]
    elif token == "-" and (before in OPERATORS or before in ("(", ",", "=", "return", "?", ":", "[")):
        found.append((end, ""))
    elif token in OPERATORS:
        found += [(end, one) for one in OPERATORS[token]]
    elif token in WORDS and (after == "(" or token in ("true", "false")):
        found += [(end, one) for one in WORDS[token]]
    elif re.match(r"\.?\d", token):
        found += [(end, one) for one in numbers(token)]
    if token == "if" and after == "(":
        close = end_of(tokens, i + 1, ")")
        found += [(tokens[close][0] + 1, f"if ({value})") for value in ("true", "false")]
    if before in ("{", "}", ";", ")", "else") and (last := statement_at(tokens, i)):
        found.append((tokens[last][0] + 1, ";"))
    return [(start, stop, one) for stop, one in found]


def faults_of(text, known):
    """The faults of a text by place: lists of (start, end, replacement). known: the text with all that it includes."""
    tokens = [(m.start(), m[0]) for m in TOKEN.finditer(text) if not re.match(r"//|/\*|\s*#", m[0])]
    places = []
    i = 0
    while i < len(tokens):
        if tokens[i][1] == "layout":  # numbers of the interface
            i = end_of(tokens, end_of(tokens, i + 1, ")"), ";{") or i
        elif tokens[i][1] == "struct":
            i = end_of(tokens, i, ";") or i
        else:
            if found := faults_at(tokens, i, known):
                places.append(found)
            if tokens[i][1] == "?":
                first = tokens[condition_before(tokens, i)][0]
                places.append([(first, tokens[i][0], value) for value in ("true ", "false ")])
        i += 1
    return places


