/** The screen to begin with: examples with their plans, a place for files, what this browser has kept. */
import { el } from '../dom';
import { worstChain } from './desk';
import type { Engine } from './engine';
import { picture } from './plan';
import { t } from './words';

const WIDE = 220;
const HIGH = 110;

export interface Beginning {
  engine(): Engine | undefined;
  examples: readonly (readonly [label: string, text: string])[];
  /** A verdict in words. */
  verdict(code: string): string;
  /** By their names in the browser's store. */
  drafts(): Map<string, { name: string; text: string }>;
  /** draft: its name in the browser's store. */
  open(text: string, name: string, draft?: string): void;
  choose(): void;
}

export class Start {
  readonly root = el('dialog', { id: 'start' });
  /** Of the examples' texts. */
  private readonly pictures = new Map<string, SVGElement>();
  private readonly verdicts = new Map<string, string>();

  constructor(private readonly from: Beginning) {
    document.body.append(this.root);
  }

  show(): void {
    this.words();
    if (!this.root.open) this.root.showModal();
    void this.draw();
  }

  close(): void {
    this.root.close();
  }

  words(): void {
    const { from } = this;
    const go = (text: string, name: string, draft?: string) => (): void => {
      this.close();
      from.open(text, name, draft);
    };
    const drafts = [...from.drafts()];
    this.root.setAttribute('aria-label', t('Begin'));
    this.root.replaceChildren(
      el(
        'p',
        {},
        t('hawser calculates the forces of a cable pull and says whether it is safe. Nothing leaves this page.'),
      ),
      el('h2', {}, t('Begin with the example that is most like your pull: everything in it can be changed')),
      el(
        'div',
        { class: 'examples' },
        ...from.examples.map(([label, text]) =>
          el(
            'button',
            { type: 'button', onclick: go(text, 'case.yaml') },
            el('span', { class: 'frame' }, this.pictures.get(text)),
            el('span', {}, t(label), this.chip(text)),
          ),
        ),
      ),
      el('h2', {}, t('Or with what you have')),
      el(
        'button',
        { type: 'button', class: 'drop', onclick: () => from.choose() },
        t('Drop a case or a route here, or choose a file'),
        el('small', {}, 'YAML, ZIP, CSV, XLSX, ODS, DXF, LandXML, IFC, GPX, KML, KMZ, GeoJSON'),
      ),
      ...(drafts.length ? [el('h2', {}, t('Kept in this browser'))] : []),
      el(
        'div',
        { class: 'buttons' },
        ...drafts.map(([key, { name, text }]) => el('button', { type: 'button', onclick: go(text, name, key) }, name)),
        el('button', { type: 'button', class: 'close', onclick: () => this.close() }, t('Back to the case')),
      ),
    );
  }

  /** What theory says of an example; empty: not yet. */
  private chip(text: string): HTMLElement {
    const code = this.verdicts.get(text);
    return el('span', { class: `chip ${code ?? ''}` }, code ? this.from.verdict(code) : '');
  }

  /** The pictures, one after the other, once the engine has time for them. */
  async draw(): Promise<void> {
    const engine = this.from.engine();
    if (!engine || !this.root.open) return;
    for (const [i, [, text]] of this.from.examples.entries()) {
      if (this.verdicts.has(text)) continue;
      const along = await engine.along(text).catch(() => undefined);
      if (!along) continue;
      const made = picture(along, WIDE, HIGH);
      this.pictures.set(text, made);
      this.root.querySelectorAll('.frame')[i]?.replaceChildren(made);
      const theory = await engine.theory(text).catch(() => undefined);
      if (!theory) continue;
      this.verdicts.set(text, worstChain(theory).one.verdict_code);
      this.root.querySelectorAll('.examples .chip')[i]?.replaceWith(this.chip(text));
    }
  }
}
