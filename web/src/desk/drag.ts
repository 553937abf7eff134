/** Handles in a drawing: dragged by pointer, stepped by arrow keys; what a drag would do is shown while it lasts, and written once. */
import { svg } from '../dom';
import { changed, type Desk } from './desk';
import type { Handle, Spot } from './handles';

const STEPS: Record<string, [number, number]> = {
  ArrowRight: [1, 0],
  ArrowLeft: [-1, 0],
  ArrowUp: [0, 1],
  ArrowDown: [0, -1],
};

const ASIDE = 24; // px

export interface Board {
  root: SVGSVGElement;
  /** From the place of the pointer to the drawing's own coordinates. */
  spot(event: PointerEvent): Spot;
  pixel(spot: Spot): Spot;
}

export class Drags {
  /** The label of the handle that had the focus: it gets it again when the drawing is made anew. */
  private focused: string | null = null;
  /** grab: from the handle's spot to where it was taken. */
  active: { handle: Handle; text: string; grab: Spot } | null = null;

  constructor(
    private readonly desk: Desk,
    private readonly board: Board,
    private readonly preview: (text: string | null, spot: Spot | null) => void,
  ) {
    const { root } = board;
    root.addEventListener('pointermove', (event) => this.move(event));
    root.addEventListener('pointerup', (event) => this.drop(event));
    root.addEventListener('pointercancel', () => this.end());
    root.addEventListener('focusin', (event) => (this.focused = (event.target as Element).getAttribute('aria-label')));
    root.addEventListener('focusout', () => {
      if (root.isConnected) this.focused = null;
    });
  }

  /** The handles as elements on the board; each has room for a finger around it. */
  draw(handles: Handle[]): SVGElement[] {
    return handles.map((handle) => {
      const [x, y] = this.board.pixel(handle.at);
      const [dx, dy] = handle.out ? [ASIDE * handle.out[0], -ASIDE * handle.out[1]] : [0, 0];
      const lead = handle.out && svg('path', { d: `M0 0L${dx.toFixed(1)} ${dy.toFixed(1)}`, class: 'lead' });
      const one = svg(
        'g',
        {
          class: `handle ${handle.kind}`,
          transform: `translate(${x.toFixed(1)} ${y.toFixed(1)})`,
          tabindex: 0,
          role: 'slider',
          'aria-label': handle.label,
          'aria-valuenow': Number.parseFloat(handle.value) || 0,
          'aria-valuetext': handle.value,
          'data-kind': handle.kind,
        },
        lead,
        svg(
          'g',
          { transform: `translate(${dx.toFixed(1)} ${dy.toFixed(1)})` },
          svg('circle', { r: 11, class: 'reach' }),
          svg('path', { d: shape(handle.kind), class: 'knob' }),
        ),
        svg('title', {}, `${handle.label}: ${handle.value}`),
      );
      one.addEventListener('pointerdown', (event) => {
        if (event.button !== 0) return;
        event.preventDefault();
        event.stopPropagation();
        this.board.root.setPointerCapture(event.pointerId);
        one.focus();
        const spot = this.board.spot(event);
        this.active = {
          handle,
          text: this.desk.text(),
          grab: [spot[0] - handle.at[0], spot[1] - handle.at[1]],
        };
      });
      one.addEventListener('focus', () => this.desk.place.mark(handle.s));
      one.addEventListener('keydown', (event) => {
        const step = STEPS[event.key];
        if (!step) return;
        event.preventDefault();
        event.stopPropagation();
        this.desk.change(handle.step(this.desk.text(), ...step), handle.label, true);
      });
      return one;
    });
  }

  /** Gives the focus back after the drawing was made anew. */
  refocus(label: string | null): void {
    if (label === null) return;
    const again = [...this.board.root.querySelectorAll<SVGElement>('.handle')];
    again.find((one) => one.getAttribute('aria-label') === label)?.focus();
  }

  get label(): string | null {
    return this.focused;
  }

  /** Where the handle is meant to be: it keeps its distance to the pointer. */
  private target(event: PointerEvent): Spot {
    const [x, y] = this.board.spot(event);
    const [dx, dy] = this.active?.grab ?? [0, 0];
    return [x - dx, y - dy];
  }

  private move(event: PointerEvent): void {
    if (!this.active) return;
    const { handle, text } = this.active;
    const spot = this.target(event);
    const change = handle.move(text, spot);
    this.preview(change ? changed(text, change) : null, spot);
  }

  private drop(event: PointerEvent): void {
    if (!this.active) return;
    const { handle, text } = this.active;
    const change = handle.move(text, this.target(event));
    this.end();
    if (text === this.desk.text() && change && changed(text, change) !== text)
      this.desk.change(change, handle.label, true);
  }

  private end(): void {
    this.active = null;
    this.preview(null, null);
  }
}

function shape(kind: Handle['kind']): string {
  if (kind === 'radius') return 'M-5 0a5 5 0 1 0 10 0a5 5 0 1 0 -10 0z';
  if (kind === 'angle' || kind === 'slope') return 'M0 -6L6 0L0 6L-6 0z';
  if (kind === 'length' || kind === 'corner' || kind === 'height') return 'M-4.5 -4.5h9v9h-9z';
  return 'M0 -6L5.5 4.5H-5.5z';
}
