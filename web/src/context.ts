// What a section of the page is made from.
import type { ReportData, RunData } from './data';
import type { FigureSpec } from './figure/spec';
import type { Store, UnitSystem } from './state';

export interface Context {
  data: ReportData;
  run: RunData;
  store: Store;
  units: UnitSystem;
  /** Makes a figure that the page looks after. */
  figure: (spec: FigureSpec) => HTMLElement;
  /** Registers what is to be called before this part of the page is thrown away. */
  onDispose: (end: () => void) => void;
}

/** A part of the page: null where the run has nothing of it. */
export type Section = (context: Context) => HTMLElement | null;
