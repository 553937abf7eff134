// A grid below everything, to see sizes and which way is level.
import { DoubleSide, Mesh, PlaneGeometry, ShaderMaterial, Vector3 } from 'three';
import { screenColour } from './material';

const vertex = /* glsl */ `
varying vec2 place;
void main() {
  place = position.xy;
  gl_Position = projectionMatrix * viewMatrix * modelMatrix * vec4(position, 1.0);
}
`;

// Lines of one pixel at every spacing, stronger at every fifth, fading with distance from what is looked at and where they get dense.
const fragment = /* glsl */ `
uniform vec3 colour;
uniform float spacing;
uniform vec3 focus;
varying vec2 place;
float lines(float apart) {
  vec2 at = place / apart;
  vec2 blur = fwidth(at);
  vec2 near = abs(fract(at - 0.5) - 0.5) / blur;
  return (1.0 - min(min(near.x, near.y), 1.0)) * (1.0 - smoothstep(0.15, 0.5, max(blur.x, blur.y)));
}
void main() {
  float fade = 1.0 - smoothstep(0.35, 1.0, distance(place, focus.xy) / focus.z);
  float strength = max(0.35 * lines(spacing), 0.8 * lines(5.0 * spacing));
  gl_FragColor = vec4(colour, strength * fade);
}
`;

export class Ground {
  readonly mesh: Mesh<PlaneGeometry, ShaderMaterial>;
  /** Distance between the lines, m. */
  spacing = 1;

  /** At height z; lines in a square of that half width. */
  constructor(z: number, half: number) {
    const material = new ShaderMaterial({
      uniforms: {
        colour: { value: screenColour('#888') },
        spacing: { value: 1 },
        focus: { value: new Vector3(0, 0, half) },
      },
      vertexShader: vertex,
      fragmentShader: fragment,
      transparent: true,
      depthWrite: false,
      side: DoubleSide,
    });
    this.mesh = new Mesh(new PlaneGeometry(2 * half, 2 * half), material);
    this.mesh.position.z = z;
    this.mesh.renderOrder = -1;
  }

  /** Lines that suit what is seen: about ten across the distance to it, a round number of `unit` (m) apart. */
  follow(x: number, y: number, distance: number, unit: number): void {
    const rough = distance / 14 / unit;
    const power = 10 ** Math.floor(Math.log10(rough));
    this.spacing = unit * power * (rough / power > 5 ? 10 : rough / power > 2 ? 5 : 2);
    const uniforms = this.mesh.material.uniforms;
    uniforms['spacing']!.value = this.spacing;
    (uniforms['focus']!.value as Vector3).set(x, y, 1.6 * distance);
  }

  recolour(css: string): void {
    this.mesh.material.uniforms['colour']!.value = screenColour(css);
  }

  dispose(): void {
    this.mesh.geometry.dispose();
    this.mesh.material.dispose();
  }
}
