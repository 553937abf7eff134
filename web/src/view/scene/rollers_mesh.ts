// All rollers in one draw call: cylinders that stay on the cable's surface when cross-sections are exaggerated.
import { CylinderGeometry, InstancedBufferAttribute, InstancedBufferGeometry, Mesh, ShaderMaterial } from 'three';
import type { Roller } from '../../data';
import { screenColour } from './material';
import type { Model } from '../states/model';
import { add, direction, type Path, sub, type Vec3 } from '../states/path';
import { lighting, type Shared, spread } from './shaders';

/** What stands for an unknown radius and width, m. */
const RADIUS = 0.1;
const WIDTH = 0.4;
/** Farther from the route than this a roller grows about itself, m. */
const NEAR = 2;
/** Largest exaggerated width, in diameters of the cable as it is drawn. */
const WIDEST = 2.2;
/** Largest drawn radius, in distances between rollers. */
const CROWDED = 0.42;

const vertex = /* glsl */ `
${spread}
uniform float widest;      // exaggerated widths end at this times the exaggeration, m
attribute vec3 base;
attribute vec4 away;       // direction from the route to the roller, and the gap between route and the roller's surface, m
attribute vec3 axis;
attribute vec4 measure;    // radius, width, largest drawn radius, m; number
varying vec3 at;
varying vec3 around;
varying float number;
void main() {
  float by = spreadBy(base);
  float radius = max(measure.x, min(by * measure.x, measure.z));
  vec3 centre = base + away.xyz * (by * away.w + radius);
  vec3 across = normalize(abs(axis.z) > 0.9 ? cross(axis, vec3(1.0, 0.0, 0.0)) : cross(axis, vec3(0.0, 0.0, 1.0)));
  mat3 turn = mat3(across, axis, cross(across, axis));
  vec3 corner = turn * (position * vec3(radius, max(measure.y, min(by * measure.y, by * widest)), radius));
  vec4 inView = viewMatrix * vec4(centre + corner, 1.0);
  at = inView.xyz;
  around = mat3(viewMatrix) * (turn * normal);
  number = measure.w;
  gl_Position = projectionMatrix * inView;
}
`;

const fragment = /* glsl */ `
${lighting}
uniform vec3 colour;
uniform vec3 pickedColour;
uniform float picked;
uniform float hovered;
varying vec3 at;
varying vec3 around;
varying float number;
void main() {
  vec3 own = abs(number - picked) < 0.5 ? pickedColour : abs(number - hovered) < 0.5 ? mix(colour, pickedColour, 0.55) : colour;
  gl_FragColor = vec4(lit(own, normalize(around), normalize(-at), 0.15), 1.0);
}
`;

/** Boxes and bell-mouths are in the list of rollers, but drawn as what they are (machines.ts). */
const isRound = ({ kind }: Roller): boolean => kind !== 'box' && kind !== 'bell-mouth';

/** Where a roller stands to the route: its foot on it, the direction from there, and the gap to the roller's surface, m. */
export function standing(path: Path | null, centre: Vec3, radius: number): { base: Vec3; away: Vec3; gap: number } {
  const found = path?.nearest(centre);
  if (!path || !found || found.distance > NEAR || found.distance < 1e-6)
    return { base: centre, away: [0, 0, -1], gap: -radius };
  const base = path.at(found.s);
  return { base, away: direction(sub(centre, base)), gap: found.distance - radius };
}

export class RollersMesh {
  readonly mesh: Mesh<InstancedBufferGeometry, ShaderMaterial>;
  /** Centres as they are drawn, [roller][xyz] m, for picking; `place` keeps them up to date with the exaggeration. */
  readonly centres: Float32Array;
  private readonly stand: { base: Vec3; away: Vec3; gap: number; radius: number; largest: number }[];

  constructor(rollers: readonly Roller[], { at, path, diameter }: Model, shared: Shared) {
    const spacing = rollerSpacing(rollers);
    this.stand = rollers.map((roller) => {
      const radius = isRound(roller) ? (roller.radius_m ?? RADIUS) : 0;
      return { ...standing(path, at(roller.position_m), radius), radius, largest: radius > 0 ? CROWDED * spacing : 0 };
    });
    this.centres = new Float32Array(3 * rollers.length);
    const unit = new CylinderGeometry(1, 1, 1, 20);
    const geometry = new InstancedBufferGeometry();
    geometry.index = unit.index;
    geometry.setAttribute('position', unit.getAttribute('position'));
    geometry.setAttribute('normal', unit.getAttribute('normal'));
    const instanced = (name: string, width: number, row: (roller: Roller, i: number) => readonly number[]): void => {
      const values = new Float32Array(width * rollers.length);
      rollers.forEach((roller, i) => values.set(row(roller, i), width * i));
      geometry.setAttribute(name, new InstancedBufferAttribute(values, width));
    };
    instanced('base', 3, (_, i) => this.stand[i]!.base);
    instanced('away', 4, (_, i) => [...this.stand[i]!.away, this.stand[i]!.gap]);
    instanced('axis', 3, (roller) => direction(roller.axis, [0, 1, 0]));
    instanced('measure', 4, (roller, i) => [
      this.stand[i]!.radius,
      isRound(roller) ? (roller.width_m ?? WIDTH) : 0,
      this.stand[i]!.largest,
      i,
    ]);
    geometry.instanceCount = rollers.length;
    const material = new ShaderMaterial({
      uniforms: {
        ...shared,
        widest: { value: WIDEST * diameter },
        colour: { value: screenColour('#8d99a6') },
        pickedColour: { value: screenColour('#e8590c') },
        picked: { value: -1 },
        hovered: { value: -1 },
      },
      vertexShader: vertex,
      fragmentShader: fragment,
    });
    this.mesh = new Mesh(geometry, material);
    this.mesh.frustumCulled = false;
    this.place(1);
  }

  /** Brings `centres` up to date. */
  place(factor: number): void {
    this.stand.forEach(({ base, away, gap, radius, largest }, i) => {
      const drawn = Math.max(radius, Math.min(factor * radius, largest));
      this.centres.set(add(base, away, factor * gap + drawn), 3 * i);
    });
  }

  /** Centre as it was drawn last. */
  centre(i: number): Vec3 {
    return [this.centres[3 * i]!, this.centres[3 * i + 1]!, this.centres[3 * i + 2]!];
  }

  /** Radius as it is drawn, m. */
  drawnRadius(i: number, factor: number): number {
    const { radius, largest } = this.stand[i]!;
    return Math.max(radius, Math.min(factor * radius, largest));
  }

  mark(picked: number, hovered: number): void {
    this.mesh.material.uniforms['picked']!.value = picked;
    this.mesh.material.uniforms['hovered']!.value = hovered;
  }

  recolour(css: string): void {
    this.mesh.material.uniforms['colour']!.value = screenColour(css);
  }

  dispose(): void {
    this.mesh.geometry.dispose();
    this.mesh.material.dispose();
  }
}

/** The usual distance between neighbours along the route, m: half of them are farther apart. */
export function rollerSpacing(rollers: readonly Roller[]): number {
  const places = rollers.map((roller) => roller.s_m).filter((s): s is number => s !== null);
  places.sort((a, b) => a - b);
  const gaps = places.slice(1).map((s, i) => s - places[i]!);
  const apart = gaps.filter((gap) => gap > 1e-3).sort((a, b) => a - b);
  return apart[Math.floor(apart.length / 2)] ?? Infinity;
}
