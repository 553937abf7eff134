// Where the camera stands, what the colours mean, how thick the cable is drawn.
import { button, el } from '../../dom';
import type { UnitSystem } from '../../state';
import { type Bend, bendText } from '../states/bends';
import type { Quantity } from '../states/quantity';

export interface Preset {
  name: string;
  key: string;
  title: string;
}

export const PRESETS: readonly Preset[] = [
  { name: 'Overview', key: '1', title: 'The whole route' },
  { name: 'Along', key: '2', title: 'Behind the head, along the cable' },
  { name: 'Plan', key: '3', title: 'From above' },
  { name: 'Profile', key: '4', title: 'From the side' },
];

/** Number key of the first bend, and how many bends have one. */
export const FIRST_BEND_KEY = 5;
export const BEND_KEYS = 5;

/** Slider of the exaggeration: its left end leaves it to the view, then powers up to this. */
const LARGEST = 100;
const STEPS = 100;

export interface ToolActions {
  preset(index: number): void;
  bend(index: number): void;
  colour(field: string): void;
  /** null: as the view thinks best. */
  factor(times: number | null): void;
}

export class ToolBar {
  readonly root: HTMLElement;
  private readonly bendList: HTMLSelectElement;
  private readonly colours: HTMLSelectElement;
  private readonly slider = el('input', { type: 'range', min: 0, max: STEPS, step: 1, value: 0, class: 'view-thick' });

  constructor(
    private readonly bends: readonly Bend[],
    quantities: readonly Quantity[],
    actions: ToolActions,
  ) {
    const presets = PRESETS.map(({ name, key, title }, i) =>
      button(name, () => actions.preset(i), { title: `${title} (${key})`, 'aria-keyshortcuts': key }),
    );
    this.bendList = el('select', { 'aria-label': 'Go to a bend', hidden: bends.length === 0 });
    this.bendList.addEventListener('change', () => {
      if (this.bendList.value) actions.bend(Number(this.bendList.value));
    });
    this.colours = el('select', {}, ...quantities.map(({ field, title }) => el('option', { value: field }, title)));
    this.colours.addEventListener('change', () => actions.colour(this.colours.value));
    this.slider.setAttribute('aria-label', 'Diameter drawn, times the true one');
    this.slider.addEventListener('input', () => {
      const at = this.slider.valueAsNumber;
      this.slider.setAttribute('aria-valuetext', at === 0 ? 'as suits the view' : `times ${factorAt(at).toFixed(1)}`);
      actions.factor(at === 0 ? null : factorAt(at));
    });
    this.root = el(
      'div',
      { class: 'view-tools' },
      el('div', { class: 'view-presets', role: 'group', 'aria-label': 'Camera' }, ...presets, this.bendList),
      el('label', { class: 'view-field' }, 'Colour', this.colours),
      el(
        'label',
        { class: 'view-field', title: 'Left end: as suits the view' },
        'Diameter: auto',
        this.slider,
        `\u00d7${LARGEST}`,
      ),
    );
    this.units('si');
  }

  /** Names of the bends in those units. */
  units(system: UnitSystem): void {
    const options = this.bends.map((bend, i) => el('option', { value: i }, bendText(bend, system)));
    this.bendList.replaceChildren(el('option', { value: '' }, 'Bend\u2026'), ...options);
  }

  coloured(field: string): void {
    this.colours.value = field;
  }

  atBend(index: number | null): void {
    this.bendList.value = index === null ? '' : String(index);
  }
}

/** Exaggeration at a step of the slider: 1 at the first, LARGEST at the last. */
export const factorAt = (step: number): number => LARGEST ** ((step - 1) / (STEPS - 1));
