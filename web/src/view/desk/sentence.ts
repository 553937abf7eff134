// What is to be seen now, in words: for those who do not see the picture, and below it for everyone.
import type { UnitSystem } from '../../state';
import { show } from '../../units';
import type { Model } from '../states/model';
import type { Now } from '../states/now';
import { lengthText, timeText } from '../states/quantity';

export function sentence(now: Now, model: Model, system: UnitSystem): string {
  const head = now.headPlace();
  const largest = now.largestTension;
  const at = largest ? model.path?.nearest(now.centre(largest.segment)) : undefined;
  const parts = [`At ${timeText(now.time, now.frames.to)}`];
  const told = [head === null ? 'the head is off the route' : `the head is at ${lengthText(head, system)}`];
  if (largest && largest.value > 0) {
    const where = !at || at.distance > 3 ? 'off the route' : `at ${lengthText(at.s, system)}`;
    told.push(`the largest tension is ${show(largest.value, 'N', system, 3)} ${where}`);
  }
  return `${parts.join('')} ${told.join(', ')}.`;
}

/** A paragraph that shows every sentence, and a hidden one that is read out when the reader has had time to listen. */
export class Narrator {
  private timer = 0;
  private last = 0;

  constructor(
    private readonly visible: HTMLElement,
    private readonly spoken: HTMLElement,
  ) {}

  /** Shows the sentence at most five times a second; speaks it once nothing has changed for `QUIET_MS`. */
  tell(words: () => string, playing: boolean): void {
    const at = performance.now();
    if (at - this.last > 200 || !playing) {
      this.visible.textContent = words();
      this.last = at;
    }
    clearTimeout(this.timer);
    this.timer = window.setTimeout(() => (this.spoken.textContent = words()), QUIET_MS);
  }

  dispose(): void {
    clearTimeout(this.timer);
  }
}

const QUIET_MS = 700;
