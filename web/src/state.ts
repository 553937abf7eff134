// What the reader of the page looks at now, shared by all figures, tables and the 3-D view: a value a key, and who wants to know.

export type UnitSystem = 'si' | 'us';
export type Theme = 'light' | 'dark';

export interface State {
  /** Place along the route under the pointer, m; null where there is none. */
  place: number | null;
  /** Simulated time that the 3-D view shows and the pointer is at, s; null: none chosen yet. */
  time: number | null;
  units: UnitSystem;
  theme: Theme;
  /** Index of the run that the single figures and the 3-D view show. */
  run: number;
  /** Index of the roller that was picked, in the order of the run's rollers; null where none is. */
  roller: number | null;
}

type Listener<K extends keyof State> = (value: State[K], source: unknown) => void;

/** Holds the state; set() tells everyone who subscribed to the key, and says who set it so that a figure can pass over itself. */
export class Store {
  private readonly listeners = new Map<keyof State, Set<Listener<never>>>();

  constructor(private readonly state: State) {}

  get<K extends keyof State>(key: K): State[K] {
    return this.state[key];
  }

  set<K extends keyof State>(key: K, value: State[K], source: unknown = null): void {
    if (Object.is(this.state[key], value)) return;
    this.state[key] = value;
    const listeners = this.listeners.get(key) as Set<Listener<K>> | undefined;
    for (const listener of [...(listeners ?? [])]) listener(value, source);
  }

  /** Calls the listener at every change of the key until the function that it returns is called. */
  subscribe<K extends keyof State>(key: K, listener: Listener<K>): () => void {
    const listeners = this.listeners.get(key) ?? new Set();
    listeners.add(listener);
    this.listeners.set(key, listeners);
    return () => void listeners.delete(listener);
  }
}
