// The page: which sections there are, in which order, and when they are made again.
import type { Context, Section } from './context';
import { pulledWith, type ReportData } from './data';
import { el, named } from './dom';
import { Figure, type Memory } from './figure/figure';
import { later } from './later';
import { title } from './run';
import { compareSection } from './section/compare';
import { alongSection, routeSection, timeSection } from './section/figures';
import { keyFiguresSection } from './section/key_figures';
import { limitsSection } from './section/limits';
import { conveyorsSection, motorsSection, reelSection, surfacesSection } from './section/machines';
import { aboutSection, eventsSection, inputsSection, trustSection } from './section/record';
import { note } from './section/parts';
import { piecesSection } from './section/pieces';
import { rollersSection } from './section/rollers';
import { verdictSection } from './section/verdict';
import type { Store } from './state';
import { toolbar } from './toolbar';
import { mountView, type View } from './view/view';

const BEFORE_VIEW: Section[] = [
  verdictSection,
  keyFiguresSection,
  compareSection,
  limitsSection,
  piecesSection,
  alongSection,
  routeSection,
];
const AFTER_VIEW: Section[] = [
  timeSection,
  eventsSection,
  rollersSection,
  conveyorsSection,
  motorsSection,
  reelSection,
  surfacesSection,
  trustSection,
  inputsSection,
  aboutSection,
];

export class Page {
  private figures: Figure[] = [];
  private ends: (() => void)[] = [];
  private readonly memory = new Map<string, Memory>();
  private readonly heading = el('header', { class: 'page-head' });
  private readonly before = el('div');
  private readonly after = el('div');
  private readonly viewRoot = el('div', { class: 'view' });
  private readonly viewPaper = el('div', { class: 'on-paper' });
  private readonly viewSection: HTMLElement;
  private readonly contents = el('nav', { class: 'contents', 'aria-label': 'Contents' });
  private view: View | null = null;

  constructor(
    root: HTMLElement,
    private readonly data: ReportData,
    private readonly store: Store,
  ) {
    this.viewSection = el(
      'section',
      { id: 'view', 'aria-labelledby': 'view-heading' },
      el('h2', { id: 'view-heading' }, 'The pull in three dimensions'),
      this.viewRoot,
      this.viewPaper,
    );
    const body = el('div', { class: 'body' }, this.before, this.viewSection, this.after);
    root.replaceChildren(toolbar(data, store), this.heading, el('div', { class: 'columns' }, this.contents, body));
    for (const key of ['units', 'theme'] as const) store.subscribe(key, () => this.fill());
    store.subscribe('run', () => {
      this.memory.clear();
      this.fill();
      this.mount();
    });
    addEventListener('beforeprint', () => this.print(true));
    addEventListener('afterprint', () => this.print(false));
    this.fill();
    later(this.viewRoot, () => this.mount());
  }

  private run(): ReportData['runs'][number] {
    const run = this.data.runs[this.store.get('run')] ?? this.data.runs[0];
    if (!run) throw new Error('The data of this page hold no run.');
    return run;
  }

  private context(): Context {
    return {
      data: this.data,
      run: this.run(),
      store: this.store,
      units: this.store.get('units'),
      figure: (spec) => {
        const memory = this.memory.get(spec.id) ?? { zoom: null, hidden: new Set(), open: false };
        this.memory.set(spec.id, memory);
        const figure = new Figure(spec, this.store, memory);
        this.figures.push(figure);
        return figure.element;
      },
      onDispose: (end) => this.ends.push(end),
    };
  }

  /** Makes everything but the toolbar and the view for the chosen run and units; the reader's place on the page stays. */
  private fill(): void {
    for (const figure of this.figures) figure.dispose();
    for (const end of this.ends) end();
    this.figures = [];
    this.ends = [];
    const context = this.context();
    const { run } = context;
    const heights = [this.before, this.after].map((part) => [part, part.offsetHeight] as const);
    for (const [part, height] of heights) part.style.minHeight = `${height}px`;
    const make = (sections: Section[]): HTMLElement[] =>
      sections.map((section) => section(context)).filter((part) => part !== null);
    this.before.replaceChildren(...make(BEFORE_VIEW));
    this.after.replaceChildren(...make(AFTER_VIEW));
    requestAnimationFrame(() => heights.forEach(([part]) => (part.style.minHeight = '')));
    const by = run.summary.version ? `simulated with hawser ${run.summary.version}` : '';
    this.heading.replaceChildren(
      el('p', { class: 'kind' }, 'Report of a cable pull'),
      el('h1', {}, named(title(run))),
      el('p', { class: 'by' }, named(run.summary.case ?? run.label), by ? ` · ${by}` : ''),
      ...(run.notes ?? []).map((sentence) => el('p', { class: 'note' }, named(sentence))),
    );
    document.title = `${title(run).slice(0, 120)} · hawser`;
    this.list();
  }

  private list(): void {
    const sections = [...document.querySelectorAll<HTMLElement>('main section[id]')];
    const links = sections.map((section) => {
      const text = section.id === 'verdict' ? 'Verdict' : (section.querySelector('h2')?.textContent ?? '');
      return el('li', {}, el('a', { href: `#${section.id}` }, text));
    });
    this.contents.replaceChildren(el('ul', {}, ...links));
  }

  private mount(): void {
    this.view?.dispose();
    this.view = null;
    const run = this.run();
    if (!run.states && !run.geometry) {
      this.viewRoot.replaceChildren(
        note(
          'These results hold neither states of the cable nor the geometry of the route, so there is nothing to play.',
        ),
      );
      return;
    }
    try {
      this.view = mountView(this.viewRoot, run, this.store, pulledWith(this.data.runs, run));
    } catch (error) {
      const why = error instanceof Error ? error.message : String(error);
      this.viewRoot.replaceChildren(note(`The view could not be made here: ${why}`));
    }
  }

  private print(on: boolean): void {
    for (const figure of this.figures) figure.print(on);
    const still = on ? (this.view?.onPaper() ?? null) : null;
    this.viewPaper.replaceChildren(...(still ? [still] : []));
    for (const details of document.querySelectorAll<HTMLDetailsElement>('details.long')) if (on) details.open = true;
  }
}
