// SPDX-License-Identifier: MIT
// G-buffer of the page, vertices: from world space to view and clip space. The projection is Vulkan's, so row 0 of the
// images is the top row, as everywhere in gloam.
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec4 color;

uniform mat4 view;        // world to view
uniform mat4 projection;  // view to clip: y down, z in [0, 1]

out vec3 view_position;
out vec3 view_normal;
out vec3 albedo;

void main() {
    vec4 at = view * vec4(position, 1.0);
    view_position = at.xyz;
    view_normal = mat3(view) * normal;
    albedo = color.rgb;
    vec4 clip = projection * at;
    gl_Position = vec4(clip.xy, 2.0 * clip.z - clip.w, clip.w);  // WebGL has z in [-1, 1]
}
