// Writes a colour whose alpha the rasterizer turns into a number of samples. Those get the whole colour, so it is not
// multiplied with alpha here.
out vec4 fragment;

void write_fragment(vec3 linear, float coverage) { fragment = vec4(encoded(linear), coverage); }
