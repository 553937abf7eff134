// The shaders' common parts. Cross-sections are drawn `spreadBy` times as large as they are, about the route: lengths along the route and
// the cable's centre line are never changed.
import { type IUniform, Vector2, Vector3, Vector4 } from 'three';

/** One set of uniforms that all materials of a view share. */
export interface Shared {
  [name: string]: IUniform;
  /** How many times larger cross-sections are drawn. */
  factor: IUniform<number>;
  /** Size of a pixel at a depth of 1 m, m. */
  pixel: IUniform<number>;
  /** The reel's centre and radius, and its axis: cable is not drawn larger on it. Radius 0: no reel. */
  reel: IUniform<Vector4>;
  reelAxis: IUniform<Vector3>;
  /** Light from the sky and share of the key light. */
  light: IUniform<Vector2>;
}

export const sharedUniforms = (): Shared => ({
  factor: { value: 1 },
  pixel: { value: 1e-3 },
  reel: { value: new Vector4(0, 0, 0, 0) },
  reelAxis: { value: new Vector3(0, 1, 0) },
  light: { value: new Vector2(0.62, 0.42) },
});

export const spread = /* glsl */ `
uniform float factor;
uniform vec4 reel;
uniform vec3 reelAxis;
float spreadBy(vec3 place) {
  if (reel.w <= 0.0) return factor;
  vec3 r = place - reel.xyz;
  r -= dot(r, reelAxis) * reelAxis;
  return mix(1.0, factor, smoothstep(1.1, 2.5, length(r) / reel.w));
}
`;

/** Colour in the light of the sky and of a lamp over the camera's left shoulder; `normal` and `eye` in camera space, unit. */
export const lighting = /* glsl */ `
uniform vec2 light;
vec3 lit(vec3 colour, vec3 normal, vec3 eye, float gloss) {
  vec3 lamp = normalize(vec3(-0.45, 0.75, 0.6));
  float sky = 0.5 + 0.5 * dot(normal, normalize((viewMatrix * vec4(0.0, 0.0, 1.0, 0.0)).xyz));
  float key = max(dot(normal, lamp), 0.0);
  float shine = pow(max(dot(normal, normalize(lamp + eye)), 0.0), 40.0);
  return colour * (light.x * (0.72 + 0.28 * sky) + light.y * key) + gloss * shine;
}
`;
