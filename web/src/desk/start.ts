/** The screen to begin with: examples with their plans, a place for files, what this browser has kept. */
import { el } from '../dom';
import type { Engine } from './engine';
import { picture } from './plan';
import { t } from './words';

const WIDE = 220;
const HIGH = 110;

export interface Beginning {
  engine(): Engine | undefined;
  examples: readonly (readonly [label: string, text: string])[];
  /** By their names in the browser's store. */
  drafts(): Map<string, { name: string; text: string }>;
  /** draft: its name in the browser's store. */
  open(text: string, name: string, draft?: string): void;
  choose(): void;
}

export class Start {
  readonly root = el('dialog', { id: 'start' });
  private readonly pictures = new Map<string, SVGElement>();

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
      el('h2', {}, t('New from an example')),
      el(
        'div',
        { class: 'examples' },
        ...from.examples.map(([label, text]) =>
          el(
            'button',
            { type: 'button', onclick: go(text, 'case.yaml') },
            el('span', { class: 'frame' }, this.pictures.get(text)),
            t(label),
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

  /** The pictures, one after the other, once the engine has time for them. */
  async draw(): Promise<void> {
    const engine = this.from.engine();
    if (!engine || !this.root.open) return;
    for (const [i, [, text]] of this.from.examples.entries()) {
      if (this.pictures.has(text)) continue;
      const along = await engine.along(text).catch(() => undefined);
      if (!along) continue;
      const made = picture(along, WIDE, HIGH);
      this.pictures.set(text, made);
      this.root.querySelectorAll('.frame')[i]?.replaceChildren(made);
    }
  }
}
