// Playback in three dimensions.
import type { RunData } from '../data';
import type { Store } from '../state';

export interface View {
  /** Frees what the view holds and empties its root. */
  dispose(): void;
}

export function mountView(root: HTMLElement, run: RunData, store: Store): View {
  void run;
  void store;
  return { dispose: () => root.replaceChildren() };
}
