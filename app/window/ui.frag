#version 450
// Encoded colours are blended as they are, like the CPU rasteriser does.
layout(set = 1, binding = 0) uniform sampler2D picture;
layout(location = 0) in vec2 uv;
layout(location = 1) in vec4 colour;
layout(location = 0) out vec4 target;

void main() { target = colour * texture(picture, uv); }
