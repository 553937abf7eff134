// What stands still: route, ducts and floors, conveyors, obstacles.
import { BufferGeometry, Float32BufferAttribute, Group, Line, LineBasicMaterial, Mesh, ShaderMaterial } from 'three';
import type { Surface } from '../data';
import { faceMaterial, type Look, screenColour } from './material';
import type { Model } from './model';
import type { Palette } from './palette';
import { add, type Vec3 } from './path';
import { obstacleMeshes, reelMesh, winchMesh } from './machines';
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
  private readonly painted: { material: ShaderMaterial | LineBasicMaterial; part: Part }[] = [];

  constructor(
    private readonly model: Model,
    private readonly shared: Shared,
    groundHeight: number,
  ) {
    const geometry = model.run.geometry;
    if (!geometry) return;
    this.route(groundHeight);
    for (const surface of geometry.surfaces) this.surface(surface);
    for (const conveyor of geometry.conveyors) this.conveyor(conveyor.points_m.map(model.at));
    const paint = (part: Part, look: Omit<Look, 'colour'> = {}): ShaderMaterial => this.paint(part, look);
    const machines = [
      ...(geometry.reel ? reelMesh(geometry.reel, model, paint) : []),
      ...(geometry.winch ? winchMesh(geometry.winch, model, paint) : []),
      ...obstacleMeshes(geometry.obstacles ?? [], model, paint),
    ];
    for (const mesh of machines) this.group.add(mesh);
  }

  private paint(part: Part, look: Omit<Look, 'colour'>): ShaderMaterial {
    const material = faceMaterial(this.shared, { colour: '#888888', ...look });
    this.painted.push({ material, part });
    return material;
  }

  /** The route as a line, and its shadow on the ground. */
  private route(groundHeight: number): void {
    const points = this.model.path?.points ?? [];
    const line = (at: readonly Vec3[], part: Part, opacity: number): void => {
      const geometry = new BufferGeometry();
      geometry.setAttribute('position', new Float32BufferAttribute(at.flat(), 3));
      const material = new LineBasicMaterial({ transparent: true, opacity });
      this.painted.push({ material, part });
      this.group.add(new Line(geometry, material));
    };
    line(points, 'route', 0.7);
    line(
      points.map(([x, y]): Vec3 => [x, y, groundHeight]),
      'grid',
      0.4,
    );
  }

  private swept(line: readonly Vec3[], profile: Corner[], closed: boolean, surface: Partial<Surface>, widen = 0): BufferGeometry {
    const fine = refined(line, PIECE_M);
    const path = this.model.path;
    const base = fine.map((point) => {
      const found = path?.nearest(point);
      return path && found && found.distance < 3 ? path.at(found.s) : point;
    });
    return sweepGeometry({ line: fine, base, profile, closed, normal: surface.normal, widen });
  }

  private surface(surface: Surface): void {
    const line = surface.points_m.map(this.model.at);
    if (line.length < 2) return;
    if (surface.diameter_m) {
      const geometry = this.swept(line, circle(0.5 * surface.diameter_m, ROUND), true, {});
      const mesh = new Mesh(geometry, this.paint('duct', { opacity: 0.13, smooth: true }));
      mesh.renderOrder = 2;
      this.group.add(mesh);
      return;
    }
    const half = 0.5 * (surface.width_m ?? FLOOR_M);
    const widen = (FLOOR_TO_CABLE * this.model.diameter) / (2 * half);
    const profile = [
      { across: 0, above: 0, wide: half },
      { across: 0, above: 0, wide: -half },
    ];
    const mesh = new Mesh(this.swept(line, profile, false, surface, widen), this.paint('floor', { opacity: 0.55 }));
    mesh.renderOrder = 1;
    this.group.add(mesh);
  }

  /** Two belts, one on either side of the cable. */
  private conveyor(line: readonly Vec3[]): void {
    if (line.length < 2) return;
    const inner = 0.5 * this.model.diameter;
    for (const across of [inner, -inner - BELT.width]) {
      const profile = box(across, BELT.width, -0.5 * BELT.height, 0.5 * BELT.height);
      this.group.add(new Mesh(this.swept(line, profile, true, {}), this.paint('belt', {})));
    }
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

/** The height of the ground below a scene of these points, m. */
export function groundBelow(points: readonly Vec3[]): number {
  const low = points.reduce((z, p) => Math.min(z, p[2]), Infinity);
  const wide = points.reduce((r, p) => Math.max(r, Math.hypot(p[0], p[1])), 1);
  return Number.isFinite(low) ? add([0, 0, low], [0, 0, 1], -Math.max(1, 0.015 * wide))[2] : -1;
}
