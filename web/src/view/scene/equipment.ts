// What stands still: route, ducts and floors, conveyors, obstacles.
import {
  BufferGeometry,
  Float32BufferAttribute,
  Group,
  Line,
  LineBasicMaterial,
  Mesh,
  ShaderMaterial,
  Vector3,
} from 'three';
import type { Conveyor, Surface } from '../../data';
import { faceMaterial, type Look, screenColour } from './material';
import type { Model } from '../states/model';
import type { Palette } from './palette';
import { direction, type Vec3 } from '../states/path';
import { obstacleMeshes, reelAngle, reelMesh, reelSpokes, winchMesh } from './machines';
import type { Shared } from './shaders';
import { box, circle, type Corner, refined, sweepGeometry } from './sweep';

/** Corners of a duct's circle; longest piece of a swept line, m. */
const ROUND = 28;
const PIECE_M = 1;
/** A floor is drawn at least this many times as wide as the exaggerated cable, a floor of unknown width this wide, m. */
const FLOOR_TO_CABLE = 1.8;
const FLOOR_M = 0.6;
/** A conveyor's belts: width and height, m. */
const BELT = { width: 0.1, height: 0.22 };

export type Part = keyof Palette;

export class Equipment {
  readonly group = new Group();
  private cast: Line | null = null;
  private spokes: Group | null = null;
  private readonly angle: ((time: number) => number) | null;
  private readonly painted: { material: ShaderMaterial | LineBasicMaterial; part: Part }[] = [];

  constructor(
    private readonly model: Model,
    private readonly shared: Shared,
    groundHeight: number,
  ) {
    const geometry = model.run.geometry;
    this.angle = reelAngle(model.run, model);
    if (!geometry) return;
    this.route(groundHeight);
    for (const surface of geometry.surfaces) this.surface(surface);
    for (const conveyor of geometry.conveyors) this.conveyor(conveyor);
    const paint = (part: Part, look: Omit<Look, 'colour'> = {}): ShaderMaterial => this.paint(part, look);
    const machines = [
      ...(geometry.reel ? reelMesh(geometry.reel, model, paint) : []),
      ...(geometry.winch ? winchMesh(geometry.winch, model, paint) : []),
      ...obstacleMeshes(geometry, model, paint),
    ];
    for (const mesh of machines) this.group.add(mesh);
    if (geometry.reel) this.group.add((this.spokes = reelSpokes(geometry.reel, model, paint)));
  }

  /** Turns the reel to where it is at a time. */
  turn(time: number): void {
    const axis = this.model.run.geometry?.reel?.axis;
    if (!axis || !this.angle) return;
    this.spokes?.quaternion.setFromAxisAngle(new Vector3(...direction(axis, [0, 1, 0])), this.angle(time));
  }

  private paint(part: Part, look: Omit<Look, 'colour'>): ShaderMaterial {
    const material = faceMaterial(this.shared, { colour: '#888888', ...look });
    this.painted.push({ material, part });
    return material;
  }

  /** The route as a line, and its shadow on the ground. */
  private route(groundHeight: number): void {
    const points = this.model.path?.points ?? [];
    const line = (at: readonly Vec3[], part: Part, opacity: number): Line => {
      const geometry = new BufferGeometry();
      geometry.setAttribute('position', new Float32BufferAttribute(at.flat(), 3));
      const material = new LineBasicMaterial({ transparent: true, opacity });
      this.painted.push({ material, part });
      const drawn = new Line(geometry, material);
      this.group.add(drawn);
      return drawn;
    };
    line(points, 'route', 0.7);
    this.cast = line(
      points.map(([x, y]): Vec3 => [x, y, groundHeight]),
      'grid',
      0.4,
    );
  }

  private swept(
    way: readonly Vec3[],
    profile: Corner[],
    closed: boolean,
    up?: readonly Vec3[] | null,
    widen = 0,
  ): BufferGeometry {
    const { line, ups } = refined(way, up?.length === way.length ? up : way.map((): Vec3 => [0, 0, 1]), PIECE_M);
    const path = this.model.path;
    const base = line.map((point) => {
      const found = path?.nearest(point);
      return path && found && found.distance < 3 ? path.at(found.s) : point;
    });
    return sweepGeometry({ line, base, profile, closed, ups, widen });
  }

  private surface(surface: Surface): void {
    const line = surface.points_m.map(this.model.at);
    if (line.length < 2) return;
    const round = surface.kind === 'duct' && surface.diameter_m;
    const geometry = round
      ? this.swept(line, circle(0.5 * round, ROUND), true, surface.up)
      : this.swept(
          line,
          trough(surface),
          false,
          surface.up ?? line.map(() => surface.normal ?? [0, 0, 1]),
          this.widening(surface),
        );
    const look = round ? this.paint('duct', { opacity: 0.13, smooth: true }) : this.paint('floor', { opacity: 0.55 });
    const mesh = new Mesh(geometry, look);
    mesh.renderOrder = round ? 2 : 1;
    this.group.add(mesh);
  }

  /** A flat floor stays wider than the cable when that is exaggerated; what has sides is exaggerated as it is. */
  private widening(surface: Surface): number {
    return (FLOOR_TO_CABLE * this.model.diameter) / (surface.width_m ?? FLOOR_M);
  }

  /** Two belts, one on either side of the cable, along the route where there is one. */
  private conveyor(conveyor: Conveyor): void {
    const { path, at } = this.model;
    const { from_m: from, to_m: to } = conveyor;
    const n = Math.max(2, Math.ceil((to - from) / PIECE_M) + 1);
    const line = path
      ? Array.from({ length: n }, (_, k) => path.at(from + ((to - from) * k) / (n - 1)))
      : conveyor.points_m.map(at);
    if (line.length < 2) return;
    const inner = 0.5 * this.model.diameter;
    for (const across of [inner, -inner - BELT.width]) {
      const profile = box(across, BELT.width, -0.5 * BELT.height, 0.5 * BELT.height);
      this.group.add(new Mesh(this.swept(line, profile, true), this.paint('belt', {})));
    }
  }

  /** Shows the route's shadow on the ground, or not. */
  shadow(on: boolean): void {
    if (this.cast) this.cast.visible = on;
  }

  recolour(palette: Palette): void {
    for (const { material, part } of this.painted)
      if (material instanceof ShaderMaterial) material.uniforms['colour']!.value = screenColour(palette[part]);
      else material.color.set(palette[part]);
  }

  dispose(): void {
    this.group.traverse((object) => {
      if (object instanceof Mesh || object instanceof Line) (object.geometry as BufferGeometry).dispose();
    });
    for (const { material } of this.painted) material.dispose();
  }
}

/** The section of a tray or a floor: flat, with sides, or a V. */
function trough({ width_m: width, height_m: height, section }: Surface): Corner[] {
  const half = 0.5 * (width ?? FLOOR_M);
  const side = height ?? 0;
  if (section === 'v') return [-half, 0, half].map((across) => ({ across, above: (side * Math.abs(across)) / half }));
  if (side > 0)
    return [
      { across: -half, above: side },
      { across: -half, above: 0 },
      { across: half, above: 0 },
      { across: half, above: side },
    ];
  return [half, -half].map((wide) => ({ across: 0, above: 0, wide }));
}

/** The height of the ground below these points, m. */
export function groundBelow(points: readonly Vec3[]): number {
  const low = points.reduce((z, p) => Math.min(z, p[2]), Infinity);
  const across = (axis: 0 | 1): number => {
    const values = points.map((p) => p[axis]);
    return values.reduce((a, b) => Math.max(a, b), -Infinity) - values.reduce((a, b) => Math.min(a, b), Infinity);
  };
  return Number.isFinite(low) ? low - Math.max(1, 0.008 * Math.hypot(across(0), across(1))) : -1;
}
