/** Help without a network: verdicts, limits, handles and keys in the desk's language; the fields by the engine's schema. */
import { el } from '../dom';
import { keys, type Schema } from './complete';
import { t } from './words';

const SHOWN = 60;
export const VERDICTS = ['safe', 'safe_if', 'not_judged', 'not_trusted', 'not_safe'];
export const LIMITS = [
  'pull',
  'restart',
  'attachment',
  'sidewall',
  'bend_radius',
  'rope_bend',
  'rope',
  'winch',
  'trip',
  'push',
  'run_away',
  'roller_steady',
  'clearance',
  'fill',
  'jam_ratio',
  'weight_correction',
];

export class Help {
  readonly root = el('div', { class: 'help' });
  private wanted = '';

  constructor(private readonly schema: () => Schema | undefined) {}

  show(): void {
    const list = (names: string[], of: string): HTMLElement =>
      el(
        'dl',
        {},
        ...names.flatMap((name) => [el('dt', {}, t(`${of} ${name}`)), el('dd', {}, t(`${of} ${name}, help`))]),
      );
    const search = el('input', {
      type: 'search',
      'aria-label': t('Search the keys of a case'),
      placeholder: 'mu_d',
    });
    search.value = this.wanted;
    const found = el('dl');
    const fill = (): void => {
      const schema = this.schema();
      const words = this.wanted.toLowerCase().split(/\s+/).filter(Boolean);
      const all = schema
        ? keys(schema).filter(({ key, words: info }) =>
            words.every((word) => `${key} ${info}`.toLowerCase().includes(word)),
          )
        : [];
      found.replaceChildren(
        ...all.slice(0, SHOWN).flatMap(({ key, words: info }) => [el('dt', {}, key), el('dd', {}, info || '–')]),
      );
    };
    search.addEventListener('input', () => {
      this.wanted = search.value;
      fill();
    });
    fill();
    this.root.replaceChildren(
      el('h3', {}, t('How it works')),
      ...['help text', 'help route', 'help handles', 'help figures', 'help keys', 'help safe'].map((one) =>
        el('p', {}, t(one)),
      ),
      el('h3', {}, t('Verdicts')),
      list(VERDICTS, 'verdict'),
      el('h3', {}, t('Limits')),
      list(LIMITS, 'limit'),
      el('h3', {}, t('Keys of a case')),
      el('p', {}, t('help schema')),
      search,
      found,
    );
  }
}
