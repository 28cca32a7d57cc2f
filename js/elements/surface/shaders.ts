// The shaders, put together from parts: the vertex shader that reads a mesh and the one that evaluates patches share
// everything but where a vertex comes from.

/** Patches of higher degrees are evaluated by the core, whatever was asked for. */
export const MAX_GPU_DEGREE = 8;

/** The numbers of the shadings in the shader, in the order of `SHADINGS`. */
export const SHADING_CODES = { smooth: 0, flat: 1, normals: 2, gaussian: 3, mean: 4, patches: 5 };

const HEAD = `#version 300 es
precision highp float;
precision highp int;
`;

/**
 * Bernstein's polynomials by their recurrence, B(n, i) = (1 − t) B(n − 1, i) + t B(n − 1, i − 1); those of the two
 * degrees below, which it passes, give the derivatives. At t = 0 and 1 all of it is exact. `net` has for each patch its two
 * degrees, then its control points.
 */
const EVALUATION = `
const int SIZE = ${MAX_GPU_DEGREE + 1};
uniform highp sampler2D net;
uniform int stride;
uniform float zeroRatio;
struct Basis { float b[SIZE]; float d[SIZE]; float dd[SIZE]; };
struct Jet { vec3 p; vec3 u; vec3 v; vec3 uu; vec3 uv; vec3 vv; };

vec4 entry(int i) {
  int width = textureSize(net, 0).x;
  return texelFetch(net, ivec2(i % width, i / width), 0);
}

Basis basisOf(int n, float t) {
  Basis r;
  for (int i = 0; i < SIZE; i++) { r.b[i] = 0.0; r.d[i] = 0.0; r.dd[i] = 0.0; }
  r.b[0] = 1.0;
  for (int m = 0; m < n; m++) {
    if (m == n - 2) for (int i = 0; i <= n; i++) {
      float below = i > 0 ? r.b[i - 1] : 0.0;
      float second = i > 1 ? r.b[i - 2] : 0.0;
      r.dd[i] = float(n * (n - 1)) * (second - 2.0 * below + r.b[i]);
    }
    if (m == n - 1) for (int i = 0; i <= n; i++) r.d[i] = float(n) * ((i > 0 ? r.b[i - 1] : 0.0) - r.b[i]);
    for (int i = m + 1; i > 0; i--) r.b[i] = r.b[i] * (1.0 - t) + r.b[i - 1] * t;
    r.b[0] *= 1.0 - t;
  }
  return r;
}

Jet jetOf(int patchIndex, vec2 uv) {
  int at = patchIndex * stride;
  ivec2 degrees = ivec2(entry(at).xy + 0.5);
  Basis bu = basisOf(degrees.x, uv.x);
  Basis bv = basisOf(degrees.y, uv.y);
  Jet jet = Jet(vec3(0), vec3(0), vec3(0), vec3(0), vec3(0), vec3(0));
  for (int j = 0; j <= degrees.y; j++) {
    vec3 row = vec3(0), du = vec3(0), duu = vec3(0);
    for (int i = 0; i <= degrees.x; i++) {
      vec3 point = entry(++at).xyz;
      row += bu.b[i] * point;
      du += bu.d[i] * point;
      duu += bu.dd[i] * point;
    }
    jet.p += bv.b[j] * row;
    jet.u += bv.b[j] * du;
    jet.v += bv.d[j] * row;
    jet.uu += bv.b[j] * duu;
    jet.uv += bv.d[j] * du;
    jet.vv += bv.dd[j] * row;
  }
  return jet;
}
`;

/** A normal that vanishes (a side that is one point) is taken from a little inside, where it has all but its limit. */
const FROM_NET = `
layout(location = 0) in vec2 uv;
const float INSIDE = 1e-3;
void vertexOf(out vec3 p, out vec3 n, out vec2 k, out float patchIndex) {
  Jet jet = jetOf(gl_InstanceID, uv);
  p = jet.p;
  vec3 c = cross(jet.u, jet.v);
  if (length(c) <= zeroRatio * (dot(jet.u, jet.u) + dot(jet.v, jet.v))) {
    jet = jetOf(gl_InstanceID, mix(uv, vec2(0.5), INSIDE));
    c = cross(jet.u, jet.v);
  }
  float area = length(c);
  n = area > 0.0 ? c / area : vec3(0);
  float e = dot(jet.u, jet.u), f = dot(jet.u, jet.v), g = dot(jet.v, jet.v);
  float l = dot(jet.uu, n), m = dot(jet.uv, n), q = dot(jet.vv, n);
  float det = area * area;
  k = det > 0.0 ? vec2((l * q - m * m) / det, (e * q - 2.0 * f * m + g * l) / (2.0 * det)) : vec2(0);
  patchIndex = float(gl_InstanceID);
}
`;

const FROM_MESH = `
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in float patchId;
layout(location = 3) in vec2 curvature;
void vertexOf(out vec3 p, out vec3 n, out vec2 k, out float patchIndex) {
  p = position;
  n = normal;
  k = curvature;
  patchIndex = patchId;
}
`;

/** `seen` is in the coordinates of the eye. */
const SURFACE_VERTEX = `
uniform mat4 view;
uniform mat4 projection;
out vec3 seen;
out vec3 seenNormal;
out vec3 ownNormal;
out vec2 curvatures;
flat out float patchNumber;
void main() {
  vec3 p;
  vertexOf(p, ownNormal, curvatures, patchNumber);
  vec4 at = view * vec4(p, 1.0);
  seen = at.xyz;
  seenNormal = mat3(view) * ownNormal;
  gl_Position = projection * at;
}
`;

const SURFACE_FRAGMENT = `${HEAD}
in vec3 seen;
in vec3 seenNormal;
in vec3 ownNormal;
in vec2 curvatures;
flat in float patchNumber;
uniform int shading;
uniform float radius;
uniform vec3 front, back, low, middle, high;
out vec4 colour;

const vec3 KEY = vec3(-0.40, 0.62, 0.68);
const vec3 FILL = vec3(0.78, -0.10, 0.61);

vec3 hue(float h) { return clamp(abs(fract(h + vec3(0.0, 2.0, 1.0) / 3.0) * 6.0 - 3.0) - 1.0, 0.0, 1.0); }

vec3 scale(float x) { return x < 0.0 ? mix(middle, low, -x) : mix(middle, high, x); }

vec3 lit(vec3 base, vec3 n) {
  vec3 toEye = normalize(-seen);
  float light = 0.40 + 0.58 * max(dot(n, KEY), 0.0) + 0.16 * max(dot(n, FILL), 0.0);
  float gloss = pow(max(dot(n, normalize(KEY + toEye)), 0.0), 48.0);
  float rim = pow(1.0 - max(dot(n, toEye), 0.0), 3.0);
  vec3 full = base * min(light + 0.12 * rim, 1.0);
  return mix(full, vec3(1.0), 0.55 * max(light - 1.0, 0.0) + 0.30 * gloss);
}

void main() {
  vec3 facet = normalize(cross(dFdx(seen), dFdy(seen)));
  bool known = dot(seenNormal, seenNormal) > 1e-12;
  vec3 n = shading == ${SHADING_CODES.flat} || !known ? facet : normalize(seenNormal) * (gl_FrontFacing ? 1.0 : -1.0);
  vec3 base = gl_FrontFacing ? front : back;
  if (shading == ${SHADING_CODES.patches}) base = mix(vec3(0.9), hue(patchNumber * 0.61803399 + 0.07), 0.62) * 0.94;
  if (shading == ${SHADING_CODES.gaussian}) base = scale(atan(curvatures.x * radius * radius * 0.37) * 0.63661977);
  if (shading == ${SHADING_CODES.mean}) base = scale(atan(curvatures.y * radius * 0.73) * 0.63661977);
  vec3 shaded = lit(base, n);
  if (shading == ${SHADING_CODES.normals}) shaded = (known ? normalize(ownNormal) : vec3(0)) * 0.5 + 0.5;
  colour = vec4(shaded, 1.0);
}
`;

/**
 * A straight piece as a band of so many pixels, drawn a little nearer than it is, so that it shows on its surface. `cap`: how far
 * it reaches beyond its ends, in widths.
 */
const BAND = `
uniform mat4 view;
uniform mat4 projection;
uniform vec2 viewport;
uniform float width;
uniform float cap;
const float LIFT = 0.9988;
void band(vec3 from, vec3 to, int corner) {
  vec4 a = projection * vec4((view * vec4(from, 1.0)).xyz * LIFT, 1.0);
  vec4 b = projection * vec4((view * vec4(to, 1.0)).xyz * LIFT, 1.0);
  vec2 along = (b.xy / b.w - a.xy / a.w) * viewport;
  float size = length(along);
  along = size > 0.0 ? along / size : vec2(1.0, 0.0);
  vec2 side = vec2(-along.y, along.x) * ((corner & 1) == 0 ? 1.0 : -1.0);
  bool first = corner < 2;
  gl_Position = first ? a : b;
  gl_Position.xy += (side + (first ? -cap : cap) * along) * width / viewport * gl_Position.w;
}
`;

const LINE_VERTEX = `
layout(location = 0) in vec3 from;
layout(location = 1) in vec3 to;
void main() { band(from, to, gl_VertexID); }
`;

const EDGE_VERTEX = `
layout(location = 0) in vec4 ends;
void main() { band(jetOf(gl_InstanceID, ends.xy).p, jetOf(gl_InstanceID, ends.zw).p, gl_VertexID & 3); }
`;

const LINE_FRAGMENT = `${HEAD}
uniform vec4 ink;
out vec4 colour;
void main() { colour = vec4(ink.rgb * ink.a, ink.a); }
`;

const PLAIN_VERTEX = `
layout(location = 0) in vec3 position;
uniform mat4 view;
uniform mat4 projection;
void main() { gl_Position = projection * vec4((view * vec4(position, 1.0)).xyz * 0.9995, 1.0); }
`;

const POINT_VERTEX = `
layout(location = 0) in vec3 position;
uniform mat4 view;
uniform mat4 projection;
uniform float width;
void main() {
  gl_Position = projection * vec4((view * vec4(position, 1.0)).xyz * 0.99, 1.0);
  gl_PointSize = width;
}
`;

/** A disc, or standing on a corner a square, with a rim in the paper's colour. */
const POINT_FRAGMENT = `${HEAD}
uniform vec4 ink;
uniform vec3 paper;
uniform bool diamond;
uniform float width;
out vec4 colour;
void main() {
  vec2 at = abs(gl_PointCoord * 2.0 - 1.0) * width * 0.5;
  float inside = width * 0.5 - (diamond ? at.x + at.y : length(at));
  float alpha = clamp(inside, 0.0, 1.0) * ink.a;
  colour = vec4(mix(paper, ink.rgb, clamp(inside - 0.14 * width, 0.0, 1.0)) * alpha, alpha);
}
`;

/** Vertex and fragment shader by the name of the program. */
export const SOURCES = {
  mesh: [HEAD + FROM_MESH + SURFACE_VERTEX, SURFACE_FRAGMENT],
  patches: [HEAD + EVALUATION + FROM_NET + SURFACE_VERTEX, SURFACE_FRAGMENT],
  lines: [HEAD + BAND + LINE_VERTEX, LINE_FRAGMENT],
  edges: [HEAD + EVALUATION + BAND + EDGE_VERTEX, LINE_FRAGMENT],
  plain: [HEAD + PLAIN_VERTEX, LINE_FRAGMENT],
  points: [HEAD + POINT_VERTEX, POINT_FRAGMENT],
};
