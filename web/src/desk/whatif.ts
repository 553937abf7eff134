/** What if: values of the case as sliders, theory of what they are set to at once; nothing is written until a button does it. */
import { isMap, isScalar, isSeq, type Node } from 'yaml';
import { el } from '../dom';
import { newest, plain, quantity, read, together, changed, type Desk } from './desk';
import type { Theory } from './engine';
import { parsed, setValue, type Path } from './splice';
import { t } from './words';

interface Knob {
  path: Path;
  label: string;
  written: string;
  value: number;
  unit: string;
  factor: number;
  least: number;
  most: number;
  step: number;
}

/** Which values are worth a slider, and how far it goes, by the value that is there. */
const KINDS: { is: RegExp; label: string; range: (value: number) => [number, number, number] }[] = [
  {
    is: /(^|\.)friction\.mu(_d|_s)?$|^theory\.stretches\.\d+\.mu(_s)?$/,
    label: 'friction',
    range: (v) => [0.02, Math.max(0.6, 2 * v), 0.01],
  },
  {
    is: /^drive\.tail\.tension$|^theory\.pits\.\d+\.back$/,
    label: 'back tension',
    range: (v) => [0, Math.max(2000, 3 * v), 10],
  },
  {
    is: /^theory\.(machine_push|feed)$|^theory\.machines\.\d+\.push$|^conveyors\.\d+\.(clamp|limit)$/,
    label: 'machine push',
    range: (v) => [100, Math.max(2000, 3 * v), 100],
  },
  {
    is: /^route\.pieces\.\d+\.radius$|^route\.radius$|^route\.points\.\d+\.3$/,
    label: 'radius',
    range: (v) => [Math.max(0.5, Math.round(5 * v) / 10), 3 * v, 0.1],
  },
];
const MOST = 40;

function knobs(text: string): Knob[] {
  const found: Knob[] = [];
  const walk = (node: unknown, path: Path, name: string): void => {
    if (isScalar(node)) {
      const kind = KINDS.find((one) => one.is.test(path.join('.')));
      const written = node.source ?? '';
      const one = read(written);
      if (!kind || !one) return;
      const [least, most, step] = kind.range(one.value);
      const label = `${t(kind.label)}${name ? `, ${name}` : ''} (${path.join('.')})`;
      found.push({ path, label, written, ...one, least, most, step });
    } else if (isMap(node)) {
      const label = node.get('name', true);
      const own = isScalar(label) ? (label.source ?? '') : name;
      for (const pair of node.items) if (isScalar(pair.key)) walk(pair.value, [...path, pair.key.value as string], own);
    } else if (isSeq(node)) (node.items as Node[]).forEach((item, i) => walk(item, [...path, i], name));
  };
  walk(parsed(text).contents, [], '');
  const order = (one: Knob): number => KINDS.findIndex((kind) => kind.is.test(one.path.join('.')));
  return found.sort((a, b) => order(a) - order(b)).slice(0, MOST);
}

export class WhatIf {
  readonly root = el('div', { class: 'whatif' });
  private readonly answer = el('div', { class: 'compare', role: 'status' });
  private readonly set = new Map<string, { path: Path; value: string }>();
  private text: string | undefined;
  private readonly ask = newest(
    async (text: string) => ({
      text,
      theory: await this.desk
        .engine()
        ?.theory(text)
        .catch(() => undefined),
    }),
    (found) => found?.text === this.changedText() && this.tell(found?.theory),
  );
  private latest: Theory | undefined;

  constructor(
    private readonly desk: Desk,
    private readonly verdict: (code: string) => string,
  ) {}

  show(): void {
    const text = this.desk.text();
    if (text !== this.text) this.set.clear();
    this.text = text;
    this.latest = undefined;
    const all = knobs(text);
    const rows = all.map((knob) => this.row(knob));
    this.root.replaceChildren(
      el('p', {}, t('Move a value: theory is calculated at once; the case stays as it is until you write it.')),
      this.answer,
      el(
        'div',
        { class: 'buttons' },
        el('button', { type: 'button', onclick: () => this.write() }, t('Write into the case')),
        el('button', { type: 'button', onclick: () => this.back() }, t('Reset the sliders')),
      ),
      rows.length
        ? el('div', { class: 'knobs' }, ...rows)
        : el('p', {}, t('The case has no value that a slider is for.')),
    );
    this.tell(undefined);
  }

  private row(knob: Knob): HTMLElement {
    const shown = el('output', {}, knob.written);
    const input = el('input', {
      type: 'range',
      min: knob.least,
      max: knob.most,
      step: knob.step,
      'aria-label': knob.label,
    });
    input.value = String(knob.value);
    input.addEventListener('input', () => {
      const next = Number(input.value);
      const value = `${plain(next / knob.factor, knob.unit === '' ? 3 : 4)} ${knob.unit}`.trim();
      shown.textContent = value;
      input.setAttribute('aria-valuetext', value);
      const key = knob.path.join('.');
      if (Math.abs(next - knob.value) < knob.step / 2) this.set.delete(key);
      else this.set.set(key, { path: knob.path, value });
      const now = this.changedText();
      if (now !== undefined) this.ask(now);
    });
    return el('label', { class: 'knob' }, el('span', {}, knob.label), input, shown);
  }

  private change(): ReturnType<typeof together> {
    return together(
      this.desk.text(),
      [...this.set.values()].map(
        ({ path, value }) =>
          (text: string) =>
            setValue(text, path, value),
      ),
    );
  }

  private changedText(): string | undefined {
    const text = this.desk.text();
    const change = this.change();
    return this.set.size === 0 ? text : change && changed(text, change);
  }

  private write(): void {
    if (this.set.size) this.desk.change(this.change(), [...this.set.keys()].join(', '), true);
  }

  private back(): void {
    this.set.clear();
    this.show();
  }

  /** The case and what the sliders say, beside each other. */
  private tell(found: Theory | undefined): void {
    this.latest = found;
    const now = this.desk.theory();
    const then = this.set.size ? this.latest : undefined;
    const us = this.desk.us();
    const row = (label: string, of: (one: Theory) => string): HTMLElement =>
      el(
        'tr',
        {},
        el('th', { scope: 'row' }, label),
        el('td', {}, now ? of(now) : '–'),
        el('td', {}, then ? of(then) : '–'),
      );
    this.answer.replaceChildren(
      el(
        'table',
        {},
        el(
          'thead',
          {},
          el('tr', {}, el('td'), el('th', { scope: 'col' }, t('The case')), el('th', { scope: 'col' }, t('What if'))),
        ),
        el(
          'tbody',
          {},
          row(t('Verdict'), (one) => this.verdict(one.verdict_code)),
          row(t('pulled forward'), (one) => quantity(one.largest_force_N, 'N', us)),
          row(t('pulled back'), (one) => quantity(one.backward_largest_force_N, 'N', us)),
          row(t('Sidewall pressure'), (one) => quantity(one.max_sidewall_N_per_m, 'N/m', us)),
        ),
      ),
    );
  }
}
