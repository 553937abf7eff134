// Chains that are pulled together with the one that is shown: where they are at its time.
import type { RunData } from '../../data';
import type { Frames } from './frames';
import { type Model, modelOf } from './model';
import { Now } from './now';

export class Beside {
  readonly models: Model[];
  readonly nows: (Now | null)[];

  constructor(
    readonly runs: readonly RunData[],
    own: Model,
  ) {
    this.models = runs.map((run) => ({ ...modelOf(run), centre: own.centre, at: own.at }));
    this.nows = runs.map(() => null);
  }

  /** Frames of one of them have come, or another field of them. */
  arrived(which: number, frames: Frames): void {
    this.nows[which] ??= new Now(frames, this.models[which]!);
  }

  /** All of them at that time. */
  show(time: number, field: string): void {
    for (const now of this.nows) now?.show(time, field);
  }
}
