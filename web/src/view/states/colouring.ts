// Which quantity colours the chain, and from where to where its colours go.
import type { Frames } from './frames';
import { type Model, onReel } from './model';
import { QUANTITIES, type Quantity } from './quantity';
import { type Scale, scaleOf } from './scale';

export class Colouring {
  readonly choices: readonly Quantity[];
  quantity: Quantity;
  private readonly scales = new Map<string, Scale | null>();

  constructor(private readonly model: Model) {
    const packed = model.run.states?.packed;
    const there = QUANTITIES.filter(({ field }) => packed && field in packed);
    this.choices = there.length > 0 ? there : QUANTITIES;
    this.quantity = this.choices[0]!;
  }

  /** There are more frames than before. */
  grown(): void {
    this.scales.clear();
  }

  choose(field: string): void {
    this.quantity = this.choices.find((quantity) => quantity.field === field) ?? this.quantity;
  }

  /** The quantity behind the present one. */
  get next(): Quantity {
    return this.choices[(this.choices.indexOf(this.quantity) + 1) % this.choices.length]!;
  }

  /** Ends of the colours over all frames; null as long as the field is not there. */
  scale(frames: Frames | undefined): Scale | null {
    const { field } = this.quantity;
    if (frames?.fields.has(field) && !this.scales.has(field))
      this.scales.set(field, scaleOf(frames, field, this.wound(frames)));
    return this.scales.get(field) ?? null;
  }

  /** Cable on the reel does not count: it is bent more than anything on the route. */
  private wound(frames: Frames): ((item: number, frame: number) => boolean) | undefined {
    const field = frames.fields.get('position');
    if (!this.model.run.geometry?.reel || !field) return undefined;
    const inside = onReel(this.model);
    const [x, y, z] = this.model.centre;
    const { q, meta } = field;
    return (item, frame) => {
      const at = 3 * (frame * frames.items + item);
      return inside(q[at]! * meta.step - x, q[at + 1]! * meta.step - y, q[at + 2]! * meta.step - z);
    };
  }
}
