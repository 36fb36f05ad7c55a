// Kajiya and Kay 1989, "Rendering fur with three dimensional textures", section 3.2.
//
//   diffuse    sin(T, L): a matte cylinder too thin to see, whose lit half is seen as a whole
//   highlight  max(sin(T, L) sin(T, V) - cos(T, L) cos(T, V), 0)^exponent color: the cosine of the angle between V and the
//              cone of mirrored light, whose axis is the strand
//
// Reads primary (rgb, exponent) of the block. As published there is one highlight, and every strand of a sheet has it at
// the same place; here the texture's shift moves it, or cards would shine like foil. Sums are multiplied with the strand's
// colour.

vec3 tint(Strand strand) { return strand.color; }

float sine_to(float cosine) { return sqrt(max(1.0 - cosine * cosine, 0.0)); }

void add_light(inout Reflected sum, Strand strand, vec3 towards, vec3 color) {
  sum.diffuse += sine_to(dot(strand.tangent, towards)) * color;
#ifdef COIF_PRIMARY
  vec3 t = shift_tangent(strand.tangent, strand.normal, strand.shift);
  float cos_l = dot(t, towards), cos_v = dot(t, strand.view);
  float to_cone = sine_to(cos_l) * sine_to(cos_v) - cos_l * cos_v;
  sum.primary += pow(max(to_cone, 0.0), primary.w) * primary.rgb * color;
#endif
}
