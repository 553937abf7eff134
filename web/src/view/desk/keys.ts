// The view's keyboard.
import { BEND_KEYS, FIRST_BEND_KEY, PRESETS } from './tool_bar';

export interface KeyActions {
  toggle(): void;
  /** Frames on or back. */
  step(frames: number): void;
  end(last: boolean): void;
  zoom(by: number): void;
  orbit(round: number, up: number): void;
  preset(index: number): void;
  bend(index: number): void;
  nextBend(step: number): void;
  event(step: number): void;
  follow(): void;
  nextColour(): void;
  toPlace(): void;
  faster(step: number): void;
  leave(): void;
}

/** What the help says, in the reader's words. */
export const HELP: readonly [string, string][] = [
  ['Space', 'play, pause'],
  ['\u2190 \u2192', 'frame by frame (Shift: ten)'],
  ['Home End', 'first, last'],
  [', .', 'slower, faster'],
  ['+ \u2212', 'zoom'],
  ['W A S D', 'turn'],
  [`1\u2013${PRESETS.length}`, 'overview, along, plan, profile'],
  [`${FIRST_BEND_KEY}\u20139`, 'bends'],
  ['B', 'next bend'],
  ['E', 'next event'],
  ['F', 'follow the head'],
  ['C', 'next colour'],
  ['Z', 'zoom to the place'],
  ['Esc', 'clear the choice'],
];

/** What a key does; null for keys that are not the view's. */
export function actionOf(key: string, shift: boolean, act: KeyActions): (() => void) | null {
  const many = shift ? 10 : 1;
  const back = shift ? -1 : 1;
  const digit = /^[1-9]$/.test(key) ? Number(key) : 0;
  if (digit > 0 && digit <= PRESETS.length) return () => act.preset(digit - 1);
  if (digit >= FIRST_BEND_KEY && digit < FIRST_BEND_KEY + BEND_KEYS) return () => act.bend(digit - FIRST_BEND_KEY);
  const actions: Record<string, () => void> = {
    ' ': () => act.toggle(),
    arrowleft: () => act.step(-many),
    arrowright: () => act.step(many),
    home: () => act.end(false),
    end: () => act.end(true),
    ',': () => act.faster(-1),
    '.': () => act.faster(1),
    '+': () => act.zoom(1 / 1.3),
    '=': () => act.zoom(1 / 1.3),
    '-': () => act.zoom(1.3),
    w: () => act.orbit(0, 5),
    s: () => act.orbit(0, -5),
    a: () => act.orbit(-5, 0),
    d: () => act.orbit(5, 0),
    b: () => act.nextBend(back),
    e: () => act.event(back),
    f: () => act.follow(),
    c: () => act.nextColour(),
    z: () => act.toPlace(),
    escape: () => act.leave(),
  };
  return actions[key.toLowerCase()] ?? null;
}

/** Keys that a control keeps for itself: text and letters in lists, space on buttons. */
function keptBy(target: EventTarget | null, key: string): boolean {
  if (target instanceof HTMLSelectElement) return key !== 'Escape';
  if (target instanceof HTMLButtonElement) return key === ' ' || key === 'Enter';
  if (target instanceof HTMLInputElement)
    return target.type === 'checkbox'
      ? key === ' '
      : !target.classList.contains('view-time') && /^(Arrow|Home|End)/.test(key);
  return false;
}

/** Listens below `root`; the function that it returns ends that. */
export function listenToKeys(root: HTMLElement, act: KeyActions): () => void {
  const pressed = (event: KeyboardEvent): void => {
    if (event.ctrlKey || event.metaKey || event.altKey || keptBy(event.target, event.key)) return;
    const action = actionOf(event.key, event.shiftKey, act);
    if (!action) return;
    event.preventDefault();
    action();
  };
  root.addEventListener('keydown', pressed);
  return () => root.removeEventListener('keydown', pressed);
}
