// Cable and rope on the graphics card: a tube that never changes, whose rings are looked up in a small texture that does.
import {
  BufferGeometry,
  DataTexture,
  Float32BufferAttribute,
  FloatType,
  FrontSide,
  LinearFilter,
  Mesh,
  NearestFilter,
  RGBAFormat,
  ShaderMaterial,
  Vector2,
  Vector3,
} from 'three';
import { ChainRings, RINGS_A_ROW, type Stretch, TEXELS } from './chain_rings';
import type { ChainDef } from '../states/model';
import { colourRow } from '../states/colours';
import { lighting, type Shared, spread } from './shaders';

const SIDES = 12;

const vertex = /* glsl */ `
${spread}
uniform sampler2D rings;
uniform float pixel;
uniform float thinnest;
attribute vec4 corner;     // ring, cosine and sine of the angle round it, -1 or 1 on the ends' faces
attribute float rim;       // 0 in the middle of an end's face
varying vec3 at;
varying vec3 around;
varying float value;
varying float arc;
void main() {
  int ring = int(corner.x + 0.5);
  ivec2 texel = ivec2((ring % ${RINGS_A_ROW}) * ${TEXELS}, ring / ${RINGS_A_ROW});
  vec4 centre = texelFetch(rings, texel, 0);
  vec4 normal = texelFetch(rings, texel + ivec2(1, 0), 0);
  vec4 tangent = texelFetch(rings, texel + ivec2(2, 0), 0);
  vec3 out_ = corner.y * normal.xyz + corner.z * cross(tangent.xyz, normal.xyz);
  float depth = -(viewMatrix * vec4(centre.xyz, 1.0)).z;
  float radius = max(normal.w * spreadBy(centre.xyz), 0.5 * thinnest * pixel * depth);
  vec4 inView = viewMatrix * vec4(centre.xyz + rim * radius * out_, 1.0);
  at = inView.xyz;
  around = mat3(viewMatrix) * (corner.w == 0.0 ? out_ : corner.w * tangent.xyz);
  value = centre.w;
  arc = tangent.w;
  gl_Position = projectionMatrix * inView;
}
`;

const fragment = /* glsl */ `
${lighting}
uniform sampler2D colours;
uniform vec2 scale;
uniform float mark;
uniform float plain;
varying vec3 at;
varying vec3 around;
varying float value;
varying float arc;
void main() {
  vec3 eye = normalize(-at);
  vec3 normal = normalize(around);
  float share = clamp((value - scale.x) / (scale.y - scale.x), 0.0, 1.0);
  vec3 colour = mix(texture2D(colours, vec2((share * 255.0 + 0.5) / 256.0, 0.5)).rgb, vec3(0.55, 0.58, 0.62), plain);
  // Marks at whole lengths of the cable: they show that it moves along itself.
  float away = abs(fract(arc / mark + 0.5) - 0.5) * mark;
  float blur = fwidth(arc);
  float dark = (1.0 - smoothstep(0.02 * mark, 0.02 * mark + blur, away)) * (1.0 - smoothstep(0.05, 0.2, blur / mark));
  float edge = pow(1.0 - max(dot(normal, eye), 0.0), 3.0);
  gl_FragColor = vec4(lit(colour * (1.0 - 0.45 * dark), normal, eye, 0.12) * (1.0 - 0.35 * edge), 1.0);
}
`;

/** Corners and triangles of a stretch's tube and its two faces. */
function stretchCorners({ first, last }: Stretch, corners: number[], rims: number[], faces: number[]): void {
  const start = rims.length;
  const push = (ring: number, k: number, end: number, rim: number): void => {
    const angle = (2 * Math.PI * k) / SIDES;
    corners.push(ring, Math.cos(angle), Math.sin(angle), end);
    rims.push(rim);
  };
  for (let ring = first; ring <= last; ring++) for (let k = 0; k < SIDES; k++) push(ring, k, 0, 1);
  for (let ring = 0; ring < last - first; ring++)
    for (let k = 0; k < SIDES; k++) {
      const a = start + ring * SIDES + k;
      const b = start + ring * SIDES + ((k + 1) % SIDES);
      faces.push(a, b, a + SIDES, b, b + SIDES, a + SIDES);
    }
  for (const end of [-1, 1]) {
    const ring = end < 0 ? first : last;
    const centre = rims.length;
    push(ring, 0, end, 0);
    for (let k = 0; k < SIDES; k++) push(ring, k, end, 1);
    for (let k = 0; k < SIDES; k++) {
      const a = centre + 1 + k;
      const b = centre + 1 + ((k + 1) % SIDES);
      faces.push(centre, ...(end < 0 ? [b, a] : [a, b]));
    }
  }
}

export class ChainMesh {
  readonly mesh: Mesh<BufferGeometry, ShaderMaterial>;
  readonly rings: ChainRings;
  private readonly texture: DataTexture;

  constructor(chain: ChainDef, shared: Shared) {
    this.rings = new ChainRings(chain);
    const { texels, rows } = this.rings;
    this.texture = new DataTexture(texels, RINGS_A_ROW * TEXELS, rows, RGBAFormat, FloatType);
    this.texture.magFilter = this.texture.minFilter = NearestFilter;
    const colours = new DataTexture(colourRow(256), 256, 1, RGBAFormat);
    colours.magFilter = colours.minFilter = LinearFilter;
    colours.needsUpdate = true;
    const corners: number[] = [];
    const rims: number[] = [];
    const faces: number[] = [];
    for (const stretch of this.rings.stretches) stretchCorners(stretch, corners, rims, faces);
    const geometry = new BufferGeometry();
    geometry.setAttribute('corner', new Float32BufferAttribute(corners, 4));
    geometry.setAttribute('rim', new Float32BufferAttribute(rims, 1));
    geometry.setIndex(faces);
    const material = new ShaderMaterial({
      uniforms: {
        ...shared,
        rings: { value: this.texture },
        colours: { value: colours },
        scale: { value: new Vector2(0, 1) },
        thinnest: { value: 2 },
        mark: { value: 1 },
        plain: { value: 1 },
      },
      vertexShader: vertex,
      fragmentShader: fragment,
      side: FrontSide,
    });
    this.mesh = new Mesh(geometry, material);
    this.mesh.frustumCulled = false;
  }

  /** Moves the tube; centres [segment][xyz] m, values [segment]. */
  update(centres: Float32Array, values: Float32Array): void {
    this.rings.update(centres, values);
    this.texture.needsUpdate = true;
  }

  /** Colours from low to high; null: no colours. */
  scale(ends: { low: number; high: number } | null): void {
    const uniforms = this.mesh.material.uniforms;
    uniforms['plain']!.value = ends ? 0 : 1;
    if (ends) (uniforms['scale']!.value as Vector2).set(ends.low, ends.high);
  }

  /** Distance between the marks on the cable, m. */
  marks(spacing: number): void {
    this.mesh.material.uniforms['mark']!.value = spacing;
  }

  /** Centre of a ring, m. */
  centre(ring: number): Vector3 {
    const at = 4 * TEXELS * ring;
    const t = this.rings.texels;
    return new Vector3(t[at], t[at + 1], t[at + 2]);
  }

  dispose(): void {
    this.texture.dispose();
    (this.mesh.material.uniforms['colours']!.value as DataTexture).dispose();
    this.mesh.material.dispose();
    this.mesh.geometry.dispose();
  }
}
