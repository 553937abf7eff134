// The states of a run as integers a field, and what lies between two of them.
import type { FieldMeta, States } from '../../data';
import { unpackField } from './packed';

export interface Field {
  meta: FieldMeta;
  /** [frame][item][component], times meta.step in SI. */
  q: Int32Array;
}

/** Where a time lies: between frame `frame` and the next, `part` of the way. */
export interface Between {
  frame: number;
  next: number;
  part: number;
}

/** The last index of an ascending list whose value is at most x; 0 where all are larger. */
export function indexAtMost(list: ArrayLike<number>, x: number): number {
  let low = 0;
  let high = list.length - 1;
  while (low < high) {
    const middle = (low + high + 1) >> 1;
    if (list[middle]! <= x) low = middle;
    else high = middle - 1;
  }
  return low;
}

/** Frames of some items (segments of the chain, rollers) over time. */
export class Frames {
  readonly time: Float64Array;
  readonly fields = new Map<string, Field>();

  constructor(
    time: ArrayLike<number>,
    readonly items: number,
  ) {
    this.time = Float64Array.from(time);
  }

  get count(): number {
    return this.time.length;
  }

  get from(): number {
    return this.time[0] ?? 0;
  }

  get to(): number {
    return this.time[this.count - 1] ?? 0;
  }

  between(time: number): Between {
    const frame = indexAtMost(this.time, time);
    const next = Math.min(frame + 1, this.count - 1);
    const span = this.time[next]! - this.time[frame]!;
    return { frame, next, part: span > 0 ? Math.min(1, Math.max(0, (time - this.time[frame]!) / span)) : 0 };
  }

  /** Values of the field at that time, [item][component] in SI less `less` a component; false where there is no such field. */
  sample(name: string, at: Between, out: Float32Array, less: readonly number[] = []): boolean {
    const field = this.fields.get(name);
    if (!field) return false;
    const { components, step } = field.meta;
    const row = this.items * components;
    const now = at.frame * row;
    const later = at.next * row;
    const q = field.q;
    for (let c = 0; c < components; c++) {
      const shift = less[c] ?? 0;
      for (let j = c; j < row; j += components) {
        const value = q[now + j]!;
        out[j] = step * (value + at.part * (q[later + j]! - value)) - shift;
      }
    }
    return true;
  }

  /** Time of the frame in which a field of one component is largest; null where there is no such field. */
  timeOfLargest(name: string): number | null {
    const q = this.fields.get(name)?.q;
    if (!q || q.length === 0) return null;
    const largest = q.reduce((most, value, i) => (value > q[most]! ? i : most), 0);
    return this.time[Math.floor(largest / this.items)] ?? null;
  }

  /** One item's value over all frames, SI; of a vector its size. */
  history(name: string, item: (frame: number) => number): Float64Array | null {
    const field = this.fields.get(name);
    if (!field) return null;
    const { components, step } = field.meta;
    return Float64Array.from(this.time, (_, frame) => {
      const at = (frame * this.items + item(frame)) * components;
      let square = 0;
      if (components === 1) return step * field.q[at]!;
      for (let c = 0; c < components; c++) square += field.q[at + c]! ** 2;
      return step * Math.sqrt(square);
    });
  }
}

/** Unpacks all fields, positions first; `arrived` is called after each. */
export async function unpackFrames(states: States, arrived: (frames: Frames, name: string) => void): Promise<Frames> {
  const frames = new Frames(states.time_s, states.segments);
  const names = Object.keys(states.packed).sort((a, b) => Number(b === 'position') - Number(a === 'position'));
  for (const name of names) {
    const meta = states.fields[name];
    if (!meta) continue;
    const q = await unpackField(states.packed[name]!, states.frames, states.segments, meta.components);
    frames.fields.set(name, { meta, q });
    arrived(frames, name);
  }
  return frames;
}
