// A model on its way to GLB: nodes with shapes, in the unit and axes of the file until the root node turns them.

/** What is wrong with a model, in words for its owner. */
export class Refused extends Error {}

/** Largest file, bytes, and the largest model that is written; the engine reads no larger ones. */
export const BYTES_MOST = 1 << 29;
export const TRIANGLES_MOST = 10_000_000;
export const NODES_MOST = 500_000;
const DEPTH_MOST = 90; // the engine reads 100 with the root and what a case puts around it

/** Three numbers a vertex; `index`: three vertices a triangle, counter-clockwise from outside, or null for a cloud of points. */
export interface Shape {
  position: Float32Array;
  index: Uint32Array | null;
}

export interface Node {
  name: string;
  /** Sixteen numbers, column by column; none: the identity. */
  matrix?: readonly number[];
  shapes?: Shape[];
  children?: Node[];
  extras?: Record<string, unknown>;
}

/** What a reader returns. */
export interface Model {
  nodes: Node[];
  /** m in a unit of the file, and the axis that points up; null: the file does not say. */
  unit: number | null;
  up: 'y' | 'z' | null;
  /** Sentences: what was left out. */
  notes: string[];
  extras?: Record<string, unknown>;
}

/** A text in UTF-8, or in UTF-16 where its first bytes say so. */
export function textOf(bytes: Uint8Array): string {
  const [a, b] = bytes;
  return new TextDecoder(
    a === 0xff && b === 0xfe ? 'utf-16le' : a === 0xfe && b === 0xff ? 'utf-16be' : 'utf-8',
  ).decode(bytes);
}

/** A shape of coordinates in double precision about a point that takes the large numbers: the node's place. */
export function shapeAbout(position: ArrayLike<number>, index: Uint32Array | null): Omit<Node, 'name'> {
  const low = [Infinity, Infinity, Infinity];
  const high = [-Infinity, -Infinity, -Infinity];
  for (let i = 0; i < position.length; i++) {
    const x = position[i]!;
    if (!Number.isFinite(x)) throw new Refused(`vertex ${Math.floor(i / 3) + 1} has a coordinate that is no number`);
    if (x < low[i % 3]!) low[i % 3] = x;
    if (x > high[i % 3]!) high[i % 3] = x;
  }
  const about = low.map((l, k) => (position.length > 0 ? Math.round(0.5 * (l + high[k]!)) : 0));
  const near = Float32Array.from({ length: position.length }, (_, i) => position[i]! - about[i % 3]!);
  return { matrix: [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, ...about, 1], shapes: [{ position: near, index }] };
}

/** Refuses what is too large or holds nothing; returns how many triangles and points there are, instances counted each. */
export function counted(nodes: readonly Node[]): { triangles: number; points: number; nodes: number } {
  const all = { triangles: 0, points: 0, nodes: 0 };
  const go = (list: readonly Node[], depth: number): void => {
    if (depth > DEPTH_MOST) throw new Refused(`its nodes are nested more than ${DEPTH_MOST} deep`);
    for (const { shapes, children, matrix, name } of list) {
      if (++all.nodes > NODES_MOST) throw new Refused(`it has more than ${NODES_MOST} nodes`);
      if (matrix && !matrix.every(Number.isFinite)) throw new Refused(`the place of '${name}' is no number`);
      for (const { position, index } of shapes ?? []) {
        if (index) all.triangles += index.length / 3;
        else all.points += position.length / 3;
      }
      if (all.triangles > TRIANGLES_MOST || all.points > TRIANGLES_MOST)
        throw new Refused(`it has more than ${TRIANGLES_MOST} triangles or points`);
      go(children ?? [], depth + 1);
    }
  };
  go(nodes, 0);
  if (all.triangles + all.points === 0) throw new Refused('it holds no surface and no points');
  return all;
}
