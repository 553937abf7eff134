// The material of everything but cable and rollers: faces whose corners stand on the route and an offset that grows with the exaggeration.
import { Color, DoubleSide, ShaderMaterial, Vector3 } from 'three';
import { lighting, type Shared, spread } from './shaders';

export interface Look {
  colour: string;
  /** 1: solid. Below: glass of this opacity, more opaque where it is seen edge-on. */
  opacity?: number;
  /** Normals from the geometry instead of from the faces. */
  smooth?: boolean;
  /** Drawn on top of everything else. */
  onTop?: boolean;
}

const vertex = /* glsl */ `
${spread}
attribute vec3 offset;
attribute vec3 side;
attribute float widen;
varying vec3 at;
varying vec3 around;
void main() {
  float by = spreadBy(position);
  vec4 inView = viewMatrix * modelMatrix * vec4(position + by * offset + max(1.0, by * widen) * side, 1.0);
  at = inView.xyz;
  around = normalMatrix * normal;
  gl_Position = projectionMatrix * inView;
}
`;

const fragment = /* glsl */ `
${lighting}
uniform vec3 colour;
uniform float opacity;
varying vec3 at;
varying vec3 around;
void main() {
  vec3 eye = normalize(-at);
#ifdef SMOOTH
  vec3 normal = normalize(around);
#else
  vec3 normal = normalize(cross(dFdx(at), dFdy(at)));
#endif
  float facing = dot(normal, eye);
  if (facing < 0.0) normal = -normal;
  float edge = pow(1.0 - abs(facing), 2.0);
  gl_FragColor = vec4(lit(colour, normal, eye, 0.08), opacity < 1.0 ? mix(opacity, min(1.0, 3.5 * opacity), edge) : 1.0);
}
`;

/** sRGB components of a CSS colour: the shaders work in the screen's colours. */
export function screenColour(css: string): Vector3 {
  const { r, g, b } = new Color(css).convertLinearToSRGB();
  return new Vector3(r, g, b);
}

export function faceMaterial(shared: Shared, look: Look): ShaderMaterial {
  const clear = (look.opacity ?? 1) < 1;
  return new ShaderMaterial({
    uniforms: { ...shared, colour: { value: screenColour(look.colour) }, opacity: { value: look.opacity ?? 1 } },
    vertexShader: vertex,
    fragmentShader: fragment,
    defines: look.smooth ? { SMOOTH: '' } : {},
    transparent: clear,
    depthWrite: !clear,
    depthTest: !look.onTop,
    side: DoubleSide,
  });
}
