// Profiles swept along a line: ducts, floors, belts, the route itself. Corners keep where they stand on the route apart from their offset from it
// (material.ts), so that the exaggeration of cross-sections is a single number on the graphics card.
import { BufferGeometry, Float32BufferAttribute } from 'three';
import { add, cross, direction, dot, size, sub, type Vec3 } from '../states/path';

/** A corner of a profile: across the line (to the left) and above it, m; the part of it that only grows to stay wider than the cable. */
export interface Corner {
  across: number;
  above: number;
  wide?: number;
}

export interface Sweep {
  /** The line, and the nearest point of the route for each of its points: height over the route grows with the exaggeration. */
  line: readonly Vec3[];
  base: readonly Vec3[];
  profile: readonly Corner[];
  closed: boolean;
  /** Direction of "above" at every point of the line. */
  ups: readonly Vec3[];
  /** Exaggeration up to which `wide` corners do not grow, turned round: they grow with exaggeration x widen where that is over 1. */
  widen?: number;
}

/** Unit vectors to the left of the line and above it at each of its points. */
export function axesAlong(line: readonly Vec3[], ups: readonly Vec3[]): { left: Vec3; above: Vec3 }[] {
  let left: Vec3 = [0, 1, 0];
  return line.map((_, i) => {
    const tangent = direction(sub(line[Math.min(line.length - 1, i + 1)]!, line[Math.max(0, i - 1)]!));
    const raw = cross(ups[i]!, tangent);
    // On a riser "above" has no direction: go on as before.
    left = size(raw) > 0.05 ? direction(raw) : direction(add(left, tangent, -dot(left, tangent)), left);
    return { left, above: cross(tangent, left) };
  });
}

export function sweepGeometry({ line, base, profile, closed, ups, widen = 0 }: Sweep): BufferGeometry {
  const positions: number[] = [];
  const offsets: number[] = [];
  const sides: number[] = [];
  const normals: number[] = [];
  const faces: number[] = [];
  const axes = axesAlong(line, ups);
  const m = profile.length;
  line.forEach((point, i) => {
    const { left, above } = axes[i]!;
    const gap = dot(sub(point, base[i]!), above);
    const foot = add(point, above, -gap);
    for (const { across, above: high, wide = 0 } of profile) {
      positions.push(...foot);
      offsets.push(...add(add([0, 0, 0], left, across), above, gap + high));
      sides.push(...add([0, 0, 0], left, wide));
      normals.push(...direction(add(add([0, 0, 0], left, across), above, high), above));
    }
    if (i === 0) return;
    for (let k = 0; k < (closed ? m : m - 1); k++) {
      const a = (i - 1) * m + k;
      const b = (i - 1) * m + ((k + 1) % m);
      faces.push(a, b, a + m, b, b + m, a + m);
    }
  });
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new Float32BufferAttribute(positions, 3));
  geometry.setAttribute('offset', new Float32BufferAttribute(offsets, 3));
  geometry.setAttribute('side', new Float32BufferAttribute(sides, 3));
  geometry.setAttribute('normal', new Float32BufferAttribute(normals, 3));
  geometry.setAttribute('widen', new Float32BufferAttribute(new Float32Array(positions.length / 3).fill(widen), 1));
  geometry.setIndex(faces);
  return geometry;
}

/** A circle, seen along the line. */
export const circle = (radius: number, corners: number): Corner[] =>
  Array.from({ length: corners }, (_, k) => {
    const angle = (2 * Math.PI * k) / corners;
    return { across: radius * Math.cos(angle), above: radius * Math.sin(angle) };
  });

/** A box from `across` to `across + width`, `low` to `high`. */
export const box = (across: number, width: number, low: number, high: number): Corner[] => [
  { across, above: low },
  { across: across + width, above: low },
  { across: across + width, above: high },
  { across, above: high },
];

/** A line with at most `longest` between its points, and what is known at its points between them: exaggerated offsets follow the route then. */
export function refined(line: readonly Vec3[], ups: readonly Vec3[], longest: number): { line: Vec3[]; ups: Vec3[] } {
  const out = { line: line.slice(0, 1), ups: ups.slice(0, 1) };
  for (let i = 1; i < line.length; i++) {
    const [a, b] = [line[i - 1]!, line[i]!];
    const pieces = Math.min(400, Math.max(1, Math.ceil(size(sub(b, a)) / longest)));
    for (let k = 1; k <= pieces; k++) {
      out.line.push(add(a, sub(b, a), k / pieces));
      out.ups.push(add(ups[i - 1]!, sub(ups[i]!, ups[i - 1]!), k / pieces));
    }
  }
  return out;
}
