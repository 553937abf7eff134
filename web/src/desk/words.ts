import { SCHEMA_ROWS } from './schema_words';
import { ROWS } from './words_table';

/** The desk's own words: English, Chinese, German. Those of theory and its page are the engine's (io/results/words.c). */
export const LANGUAGES = ['en', 'zh', 'de'] as const;
export type Language = (typeof LANGUAGES)[number];

let language: Language = 'en';
const missing = new Set<string>();

const rows = new Map([...SCHEMA_ROWS, ...ROWS].map((row) => [row[0], row]));

export const languageNow = (): Language => language;
export const languageNumber = (): number => LANGUAGES.indexOf(language);
export const setLanguage = (next: Language): void => void (language = next);

/** A text of the desk in the language that is set, by its row; {1} and {2} in it are replaced. */
export function t(english: string, ...parts: string[]): string {
  const row = rows.get(english);
  if (!row && english) missing.add(english);
  const [, zh, de, en] = row ?? [];
  const text = { en, zh, de }[language] ?? english;
  return text.replace(/\{(\d)\}/g, (_, i: string) => parts[Number(i) - 1] ?? '');
}

/** For tests: texts that have been shown and stand in no row. */
export const withoutRow = (): string[] => [...missing];

/** Elements of the page that say their text or label themselves: data-t, data-t-label. */
export function translate(root: ParentNode): void {
  for (const one of root.querySelectorAll<HTMLElement>('[data-t]')) one.textContent = t(one.dataset['t'] ?? '');
  for (const one of root.querySelectorAll<HTMLElement>('[data-t-label]')) {
    one.setAttribute('aria-label', t(one.dataset['tLabel'] ?? ''));
    if (one.title) one.title = t(one.dataset['tLabel'] ?? '');
  }
  document.documentElement.lang = language;
}
