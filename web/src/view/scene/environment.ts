// The environment: models of the tunnel and of what stands in it. What lies between the route and the camera is cut away.
import {
  BufferAttribute,
  BufferGeometry,
  DoubleSide,
  Group,
  type IUniform,
  Mesh,
  Points,
  ShaderMaterial,
  type Vector3,
} from 'three';
import type { Surroundings } from '../../data';
import { unpackField } from '../states/packed';
import type { Model } from '../states/model';
import type { Vec3 } from '../states/path';
import { screenColour } from './material';
import { lighting, type Shared } from './shaders';

/** Points of the route that are enough to say which side of it something is on. */
const OUTLINE = 400;

// `base` is the nearest point of the route. What is farther toward the camera than that is in front of the route.
const vertex = /* glsl */ `
attribute vec3 base;
attribute float layer;
varying vec3 at;
varying float front;
varying float number;
void main() {
  vec4 inView = viewMatrix * modelMatrix * vec4(position, 1.0);
  vec3 foot = (viewMatrix * modelMatrix * vec4(base, 1.0)).xyz;
  at = inView.xyz;
  front = dot(at - foot, normalize(-foot));
  number = layer;
  gl_Position = projectionMatrix * inView;
  gl_PointSize = 2.0;
}
`;

// A faded surface has holes between its pixels, so that nothing has to be sorted.
const fragment = /* glsl */ `
${lighting}
uniform vec3 colour;
uniform float fade;
uniform float cut;
varying vec3 at;
varying float front;
varying float number;
void main() {
  if (front > cut) discard;
  if (fract(52.9829189 * fract(dot(floor(gl_FragCoord.xy), vec2(0.06711056, 0.00583715)))) >= fade) discard;
  vec3 tint = colour * (1.0 + 0.12 * sin(number * vec3(2.4, 4.1, 5.3)));
#ifdef CLOUD
  gl_FragColor = vec4(tint, 1.0);
#else
  vec3 eye = normalize(-at);
  vec3 normal = normalize(cross(dFdx(at), dFdy(at)));
  gl_FragColor = vec4(lit(tint, dot(normal, eye) < 0.0 ? -normal : normal, eye, 0.0), 1.0);
#endif
}
`;

/** Triangles or points, sorted by their layers, with the numbers of the corners of those that are shown. */
interface Drawn {
  geometry: BufferGeometry;
  /** Corners of layer i: from[i] to from[i + 1]. */
  from: Uint32Array;
}

export class Environment {
  readonly group = new Group();
  readonly shown: boolean[];
  private readonly drawn: Drawn[] = [];
  private readonly materials: ShaderMaterial[] = [];
  private readonly own: { colour: IUniform<Vector3>; fade: IUniform<number>; cut: IUniform<number> } = {
    colour: { value: screenColour('#888888') },
    fade: { value: 1 },
    cut: { value: 0 },
  };

  constructor(
    readonly of: Surroundings,
    private readonly model: Model,
    private readonly shared: Shared,
  ) {
    this.shown = of.layers.map(() => true);
  }

  /** Unpacks it; the picture is complete then. */
  async unpack(): Promise<void> {
    const { of, model } = this;
    const [points, corners, layers] = await Promise.all([
      unpackField(of.points, 1, of.n_points, 3),
      unpackField(of.triangles, 1, of.n_triangles, 3),
      unpackField(of.layer, 1, of.n_triangles, 1),
    ]);
    const position = Float32Array.from(points, (q, i) => q * of.step_m - model.centre[(i % 3) as 0 | 1 | 2]);
    const base = feet(position, model.path?.points ?? []);
    const isPoint = (k: number): boolean =>
      corners[3 * k] === corners[3 * k + 1] && corners[3 * k] === corners[3 * k + 2];
    const all = Array.from({ length: of.n_triangles }, (_, k) => k).sort((a, b) => layers[a]! - layers[b]!);
    this.add(
      all.filter((k) => !isPoint(k)),
      3,
      position,
      base,
      corners,
      layers,
    );
    this.add(all.filter(isPoint), 1, position, base, corners, layers);
    this.choose();
  }

  /** Makes one thing to draw of the triangles (3 corners) or points (1) of these numbers. */
  private add(
    numbers: number[],
    each: 1 | 3,
    position: Float32Array,
    base: Float32Array,
    corners: Int32Array,
    layers: Int32Array,
  ): void {
    if (numbers.length === 0) return;
    const count = each * numbers.length;
    const spread = (from: Float32Array): Float32Array => {
      const to = new Float32Array(3 * count);
      for (let i = 0; i < count; i++) {
        const corner = corners[3 * numbers[Math.floor(i / each)]! + (i % each)]!;
        for (let k = 0; k < 3; k++) to[3 * i + k] = from[3 * corner + k]!;
      }
      return to;
    };
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', new BufferAttribute(spread(position), 3));
    geometry.setAttribute('base', new BufferAttribute(spread(base), 3));
    const layer = Float32Array.from({ length: count }, (_, i) => layers[numbers[Math.floor(i / each)]!]!);
    geometry.setAttribute('layer', new BufferAttribute(layer, 1));
    const from = new Uint32Array(this.shown.length + 1);
    for (const number of layer) from[number + 1]!++;
    for (let i = 0; i < this.shown.length; i++) from[i + 1]! += from[i]!;
    const material = new ShaderMaterial({
      uniforms: { ...this.shared, ...this.own },
      vertexShader: vertex,
      fragmentShader: fragment,
      defines: each === 1 ? { CLOUD: '' } : {},
      side: DoubleSide,
    });
    this.materials.push(material);
    this.drawn.push({ geometry, from });
    const thing = each === 1 ? new Points(geometry, material) : new Mesh(geometry, material);
    thing.frustumCulled = false;
    this.group.add(thing);
  }

  /** Draws the layers that are shown. */
  choose(): void {
    for (const { geometry, from } of this.drawn) {
      const parts = this.shown.map((on, i) => (on ? from[i + 1]! - from[i]! : 0));
      const index = new Uint32Array(parts.reduce((a, b) => a + b, 0));
      let at = 0;
      parts.forEach((count, i) => {
        for (let k = 0; k < count; k++) index[at++] = from[i]! + k;
      });
      geometry.setIndex(new BufferAttribute(index, 1));
    }
  }

  /** 1: solid, 0: not there. */
  fade(share: number): void {
    this.own.fade.value = share;
    this.group.visible = share > 0;
  }

  cut(on: boolean): void {
    this.own.cut.value = on ? 0 : 1e9;
  }

  recolour(colour: string): void {
    this.own.colour.value = screenColour(colour);
  }

  dispose(): void {
    this.drawn.forEach(({ geometry }) => geometry.dispose());
    this.materials.forEach((material) => material.dispose());
  }
}

/** For each point the nearest one of a line; without a line the point itself, which is then never in front. */
export function feet(position: Float32Array, line: readonly Vec3[]): Float32Array {
  const stride = Math.max(1, Math.ceil(line.length / OUTLINE));
  const few = line.filter((_, i) => i % stride === 0 || i === line.length - 1);
  const base = position.slice();
  if (few.length < 2) return base;
  const flat = Float64Array.from(few.flat());
  for (let p = 0; p < position.length; p += 3) {
    const [x, y, z] = [position[p]!, position[p + 1]!, position[p + 2]!];
    let best = Infinity;
    for (let i = 0; i + 5 < flat.length; i += 3) {
      const [ax, ay, az] = [flat[i]!, flat[i + 1]!, flat[i + 2]!];
      const [tx, ty, tz] = [flat[i + 3]! - ax, flat[i + 4]! - ay, flat[i + 5]! - az];
      const along = ((x - ax) * tx + (y - ay) * ty + (z - az) * tz) / (tx * tx + ty * ty + tz * tz);
      const share = Math.min(1, Math.max(0, along));
      const [fx, fy, fz] = [ax + share * tx, ay + share * ty, az + share * tz];
      const square = (x - fx) ** 2 + (y - fy) ** 2 + (z - fz) ** 2;
      if (square >= best) continue;
      best = square;
      base[p] = fx;
      base[p + 1] = fy;
      base[p + 2] = fz;
    }
  }
  return base;
}
