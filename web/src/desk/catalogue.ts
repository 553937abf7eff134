/** Cable and duct: the engine's cross-sections with fill, clearance and jam, and the catalogue, out of which a type is put into the case. */
import { isMap, isScalar, isSeq } from 'yaml';
import { el } from '../dom';
import { digits } from '../units';
import { quantity, together, type Desk } from './desk';
import type { Duct, Entry } from './engine';
import { nodeAt, parsed, removeKey, setValue, type Change, type Path } from './splice';
import { t } from './words';

const SHOWN = 40;

/** Which keys of a target an entry brings: they give way to it. */
const KINDS: Record<string, { keys: string[]; targets: string[] }> = {
  cables: { keys: ['d', 'mass', 'density', 'E', 'G', 'A', 'EA', 'GA', 'GJ', 'EI', 'conductor'], targets: ['cables.*'] },
  ropes: { keys: ['d', 'mass', 'density', 'E', 'G', 'A', 'EA', 'GA', 'GJ', 'EI'], targets: ['cables.*'] },
  ducts: { keys: ['radius'], targets: ['surfaces.ducts.*'] },
  friction: {
    keys: ['mu', 'mu_d', 'mu_s'],
    targets: ['friction', 'surfaces.ducts.*.friction', 'surfaces.trays.*.friction'],
  },
  rollers: { keys: ['radius', 'width', 'rating', 'profile', 'groove'], targets: ['rollers.along', 'rollers.along.*'] },
  reels: { keys: [], targets: ['reel'] },
};

function targets(text: string, kind: string): Path[] {
  const document = parsed(text);
  return (KINDS[kind]?.targets ?? []).flatMap((pattern) => {
    let paths: Path[] = [[]];
    for (const step of pattern.split('.'))
      paths = paths.flatMap((path) => {
        if (step !== '*') return [[...path, step]];
        const node = nodeAt(document, path);
        if (isSeq(node)) return node.items.map((_, i) => [...path, i]);
        if (isMap(node))
          return node.items.flatMap((pair) => (isScalar(pair.key) ? [[...path, String(pair.key.value)]] : []));
        return [];
      });
    return paths.filter((path) => isMap(nodeAt(document, path)));
  });
}

/** The change that names an entry in place of what is written there. */
function use(text: string, path: Path, kind: string, name: string): Change | undefined {
  const has = (now: string, key: string): boolean => nodeAt(parsed(now), [...path, key]) !== undefined;
  return together(text, [
    (now) => setValue(now, [...path, 'type'], name),
    ...(KINDS[kind]?.keys ?? [])
      .filter((key) => has(text, key))
      .map((key) => (now: string) => removeKey(now, [...path, key])),
  ]);
}

export class Catalogue {
  readonly root = el('div', { class: 'catalogue' });
  private readonly found = el('div', { class: 'found', role: 'region' });
  private readonly sections = el('div', { class: 'cross' });
  private kind = 'cables';
  private words = '';
  private target = '';
  private readonly entries = new Map<string, Entry[]>();

  constructor(
    private readonly desk: Desk,
    private readonly page: () => string,
  ) {}

  show(): void {
    const kinds = Object.keys(KINDS);
    const kind = el(
      'select',
      { 'aria-label': t('Kind') },
      ...kinds.map((one) => el('option', { value: one }, t(`kind ${one}`))),
    );
    kind.value = this.kind;
    kind.addEventListener('change', () => {
      this.kind = kind.value;
      this.show();
    });
    const search = el('input', {
      type: 'search',
      'aria-label': t('Search the catalogue'),
      placeholder: '110kv 800 cu',
    });
    search.value = this.words;
    search.addEventListener('input', () => {
      this.words = search.value;
      void this.list();
    });
    const places = targets(this.desk.text(), this.kind).map((path) => path.join('.'));
    if (!places.includes(this.target)) this.target = places[0] ?? '';
    const target = el('select', { 'aria-label': t('For') }, ...places.map((one) => el('option', { value: one }, one)));
    target.value = this.target;
    target.addEventListener('change', () => (this.target = target.value));
    this.root.replaceChildren(
      this.sections,
      el('h3', {}, t('Catalogue')),
      el(
        'div',
        { class: 'buttons' },
        kind,
        search,
        places.length ? el('label', { class: 'for' }, t('For'), target) : t('The case has no place for it.'),
      ),
      this.found,
    );
    this.cross();
    void this.list();
  }

  /** The drawings of the engine's page, and how near each is to what is allowed. */
  cross(): void {
    const theory = this.desk.theory();
    const ducts = theory?.ducts ?? [];
    const drawn = new DOMParser().parseFromString(this.page(), 'text/html').querySelectorAll('.ducts figure');
    const limit = (name: string): number | null =>
      theory?.limits?.find((one) => one.name === name && one.direction === 'forward')?.limit ?? null;
    const us = this.desk.us();
    const rows: [string, (duct: Duct) => string, string][] = [
      [
        'fill',
        (duct) => `${digits(100 * duct.fill, 3)} %`,
        limit('fill') === null ? '–' : `≤ ${digits(100 * (limit('fill') ?? 0), 3)} %`,
      ],
      [
        'clearance',
        (duct) => quantity(duct.clearance_m, 'mm', us, 3),
        `≥ ${quantity(limit('clearance'), 'mm', us, 3)}`,
      ],
      [
        'jam ratio',
        (duct) =>
          `${duct.jam_ratio === null || duct.jam_risk === 'none' ? '–' : digits(duct.jam_ratio, 3)} (${t(`jam ${duct.jam_risk}`)})`,
        limit('jam_ratio') === null ? '–' : digits(limit('jam_ratio') ?? 0, 3),
      ],
      ['weight factor', (duct) => digits(duct.weight_factor, 3), ''],
    ];
    this.sections.replaceChildren(
      el('h3', {}, t('Cross-section')),
      ducts.length
        ? el('div', { class: 'ducts' }, ...[...drawn].map((one) => document.importNode(one, true)))
        : el('p', {}, t('The case has no ducts.')),
      ...(ducts.length === 0
        ? []
        : [
            el(
              'div',
              { class: 'wide', tabindex: 0, role: 'region', 'aria-label': t('Cross-section') },
              el(
                'table',
                { class: 'list' },
                el(
                  'thead',
                  {},
                  el(
                    'tr',
                    {},
                    el('td'),
                    ...ducts.map((duct) => el('th', { scope: 'col' }, duct.name)),
                    el('th', { scope: 'col' }, t('allowed')),
                  ),
                ),
                el(
                  'tbody',
                  {},
                  ...rows.map(([label, of, allowed]) =>
                    el(
                      'tr',
                      {},
                      el('th', { scope: 'row' }, t(label)),
                      ...ducts.map((duct) => el('td', {}, of(duct))),
                      el('td', {}, allowed),
                    ),
                  ),
                ),
              ),
            ),
          ]),
    );
  }

  private async list(): Promise<void> {
    const kind = this.kind;
    if (!this.entries.has(kind))
      this.entries.set(
        kind,
        (await this.desk
          .engine()
          ?.library(kind)
          .catch(() => [])) ?? [],
      );
    if (kind !== this.kind) return;
    const wanted = this.words.toLowerCase().split(/\s+/).filter(Boolean);
    const all = (this.entries.get(kind) ?? []).filter((one) => {
      const words = `${one.name} ${one.figures} ${one.note}`.toLowerCase();
      return wanted.every((word) => words.includes(word));
    });
    this.found.setAttribute('aria-label', t('Catalogue'));
    this.found.replaceChildren(
      el(
        'p',
        { role: 'status' },
        t('{1} found', String(all.length)) +
          (all.length > SHOWN ? ` – ${t('the first {1} are shown', String(SHOWN))}` : ''),
      ),
      ...all.slice(0, SHOWN).map((one) =>
        el(
          'div',
          { class: 'entry' },
          el(
            'button',
            {
              type: 'button',
              'aria-label': `${t('Use')} ${one.name}`,
              disabled: !this.target,
              onclick: () => this.put(one.name),
            },
            t('Use'),
          ),
          el(
            'div',
            { lang: 'en' },
            el('b', {}, one.name),
            ` ${one.figures}`,
            el('small', {}, ` ${one.note} – ${one.mark}, ${one.source}`),
          ),
        ),
      ),
    );
  }

  private put(name: string): void {
    const path: Path = this.target.split('.').map((step) => (/^\d+$/.test(step) ? Number(step) : step));
    const change = use(this.desk.text(), path, this.kind, name);
    this.desk.change(change, this.target, true);
    const own = nodeAt(parsed(this.desk.text()), ['limits', 'conductor']) !== undefined;
    if (change && this.kind === 'cables' && own)
      this.desk.say(t('The limits name a conductor of their own: see limits.conductor.'));
  }
}
