// The chain at the time that is shown: centres and one field, between two frames; and where its extremes are.
import type { Frames } from './frames';
import type { Model } from './model';
import type { Vec3 } from './path';

export class Now {
  /** [segment][xyz], m about the model's centre. */
  readonly centres: Float32Array;
  /** [segment], of the field that colours the chain. */
  readonly values: Float32Array;
  private readonly tension: Float32Array;
  time = 0;

  constructor(
    readonly frames: Frames,
    private readonly model: Model,
  ) {
    this.centres = new Float32Array(3 * frames.items);
    this.values = new Float32Array(frames.items);
    this.tension = new Float32Array(frames.items);
  }

  /** Brings everything to that time; false as long as there are no positions. */
  show(time: number, field: string): boolean {
    const between = this.frames.between(time);
    if (!this.frames.sample('position', between, this.centres, this.model.centre)) return false;
    if (!this.frames.sample(field, between, this.values)) this.values.fill(0);
    this.frames.sample('tension', between, this.tension);
    this.time = time;
    return true;
  }

  centre(segment: number): Vec3 {
    const c = this.centres;
    return [c[3 * segment]!, c[3 * segment + 1]!, c[3 * segment + 2]!];
  }

  /** Largest tension and its segment; null without tensions. */
  get largestTension(): { segment: number; value: number } | null {
    if (!this.frames.fields.has('tension')) return null;
    let segment = 0;
    for (let i = 1; i < this.tension.length; i++) if (this.tension[i]! > this.tension[segment]!) segment = i;
    return { segment, value: this.tension[segment]! };
  }

  /** Place of the cable's front along the route; null where it is not known. */
  headPlace(time = this.time): number | null {
    const places = this.model.run.states?.head_at_m ?? [];
    const { frame, next, part } = this.frames.between(time);
    const a = places[frame] ?? null;
    const b = places[next] ?? null;
    if (a !== null && b !== null) return a + part * (b - a);
    return this.model.path?.nearest(this.centre(this.model.head)).s ?? null;
  }

  /** For every frame the segment that is nearest to a point; its distance, m, is 0 or more than `reach` where nothing is there. */
  segmentsAt(point: Vec3, reach: number): Int32Array {
    const field = this.frames.fields.get('position');
    const segments = new Int32Array(this.frames.count).fill(-1);
    if (!field) return segments;
    const { q, meta } = field;
    const [x, y, z] = point.map((value, i) => (value + this.model.centre[i]!) / meta.step) as Vec3;
    const row = 3 * this.frames.items;
    for (let frame = 0; frame < this.frames.count; frame++) {
      let least = (reach / meta.step) ** 2;
      for (let i = 0, at = frame * row; i < this.frames.items; i++, at += 3) {
        const square = (q[at]! - x) ** 2 + (q[at + 1]! - y) ** 2 + (q[at + 2]! - z) ** 2;
        if (square < least) {
          least = square;
          segments[frame] = i;
        }
      }
    }
    return segments;
  }
}
