/** The screen Simulate: what a run will take, the run while it is computed, its report. It goes on while the desk is used. */
import { el } from '../dom';
import type { ReportData } from '../data';
import type { Live, live } from '../live';
import { bytesOf, inflated, messageOf, type Engine, type Moment } from './engine';
import { Run, Stopped, type RunParts } from './run_worker';
import { t } from './words';

export interface Desk {
  engine(): Engine | undefined;
  current(): string;
  name(): string;
  us(): boolean;
  force: (newtons: number) => string;
  download(name: string, content: string, type: string): void;
}

/** What `hawser check --format json` has. */
interface Estimate {
  segments: number;
  duration_s: number;
  time_s: number | null;
}

type ShowsRuns = Window & { hawserLive?: typeof live };

const text = (id: string): string => document.getElementById(id)?.textContent ?? '';
const seconds = (s: number): string => (s < 100 ? `${s.toPrecision(2)} s` : `${Math.round(s / 60)} min`);

/** The report's program alone, for a run that goes on. */
const livePage = (): string =>
  `<!doctype html><html lang="en"><head><meta charset="utf-8"><title>run</title><style>${text('report-style')}</style></head>` +
  `<body><main id="live"></main><script>${text('report-script')}</script></body></html>`;

/** The report of a run that has not come to its end; '': there is nothing that it could be made of. */
const unfinished = (parts: RunParts): Promise<string> =>
  new Run(parts, { call: 'report', args: [] }).done.then(
    (end) => end.report,
    () => '',
  );

export class Simulation {
  private readonly opener: HTMLButtonElement;
  private readonly root: HTMLElement;
  private readonly status = el('p', { role: 'status', id: 'run-status' });
  private readonly about = el('p', { class: 'about' });
  private readonly estimate = el('p', { id: 'run-estimate' });
  private readonly stale = el('p', { id: 'run-stale' });
  private readonly bar = el('progress', { max: 1, value: 0, hidden: true });
  private readonly frame = el('iframe', { id: 'run-page', hidden: true });
  private readonly startButton: HTMLButtonElement;
  private readonly stopButton: HTMLButtonElement;
  private readonly saveButton: HTMLButtonElement;
  private readonly printButton: HTMLButtonElement;
  private run: Run | null = null;
  private shows: Live | null = null;
  private last: Moment | null = null;
  /** The moment of the largest force at the winch so far. */
  private most: Moment | null = null;
  /** Text and name of the case that runs or has run. */
  private ran: { text: string; name: string } | null = null;

  constructor(private readonly desk: Desk) {
    this.opener = document.getElementById('simulate') as HTMLButtonElement;
    const button = (onclick: () => void, kind = ''): HTMLButtonElement =>
      el('button', { type: 'button', class: kind, onclick });
    this.startButton = button(() => void this.start(), 'first');
    this.stopButton = button(() => this.run?.stop());
    this.saveButton = button(() =>
      desk.download(`${this.ran?.name.replace(/\.ya?ml$/, '') ?? 'run'}-report.html`, this.frame.srcdoc, 'text/html'),
    );
    this.printButton = button(() => this.frame.contentWindow?.print());
    this.back = button(() => this.show(false));
    this.root = el(
      'section',
      { id: 'simulation', hidden: true },
      el(
        'div',
        { class: 'bar' },
        this.back,
        this.startButton,
        this.stopButton,
        this.saveButton,
        this.printButton,
        this.bar,
      ),
      this.about,
      this.estimate,
      this.status,
      this.stale,
      this.frame,
    );
    document.querySelector('main')?.after(this.root);
    this.opener.addEventListener('click', () => this.show(true));
    this.words();
    this.buttons();
  }

  private readonly back: HTMLButtonElement;

  /** Its texts again, in the language of now. */
  words(): void {
    this.root.setAttribute('aria-label', t('Simulation'));
    this.frame.title = t('The run');
    this.about.textContent = t(
      'A simulation moves the cable step by step: it adds to theory what rollers, sag, stiffness and starting do. Start it; the desk can be used meanwhile.',
    );
    this.back.textContent = t('Back to the case');
    this.startButton.textContent = t('Start');
    this.stopButton.textContent = t('Stop');
    this.saveButton.textContent = t('Save the report');
    this.printButton.textContent = t('Print the report');
    if (!this.run) this.opener.textContent = t('Simulate');
  }

  private buttons(report = false): void {
    this.startButton.disabled = !!this.run;
    this.stopButton.disabled = !this.run;
    this.saveButton.disabled = this.printButton.disabled = !report;
    this.bar.hidden = !this.run;
    if (!this.run) this.opener.textContent = t('Simulate');
  }

  show(on: boolean): void {
    this.root.hidden = !on;
    (document.querySelector('main') as HTMLElement).hidden = on;
    this.stale.textContent =
      this.ran && this.ran.text !== this.desk.current() ? t('The case has changed since this run.') : '';
    if (on && !this.run) void this.expect();
    (on ? this.back : this.opener).focus();
  }

  private async expect(): Promise<void> {
    this.estimate.textContent = '';
    this.startButton.disabled = true;
    try {
      const said = JSON.parse((await this.desk.engine()?.call('cost', this.desk.current())) ?? '{}') as Estimate;
      const [n, s] = [String(said.segments), String(said.duration_s)];
      this.estimate.textContent =
        said.time_s === null
          ? t('{1} segments, {2} s of the pull. How long it takes is not known before.', n, s)
          : t(
              '{1} segments, {2} s of the pull. The program computes it in about {3}; in the browser it takes one to five times as long.',
              n,
              s,
              seconds(said.time_s),
            );
      this.startButton.disabled = !!this.run;
    } catch (why) {
      this.estimate.textContent = messageOf(why);
    }
  }

  async start(): Promise<void> {
    const { desk } = this;
    if (this.run) return;
    this.ran = { text: desk.current(), name: desk.name() };
    this.startButton.disabled = true;
    this.stale.textContent = '';
    this.status.textContent = t('The engine is starting.');
    this.shows = this.last = this.most = null;
    this.frame.hidden = true; // what is in it is of another run
    this.about.hidden = true;
    const encoded = (id: string): Uint8Array<ArrayBuffer> => new TextEncoder().encode(text(id));
    const files = new Map(desk.engine()?.files ?? []);
    files.set('/web/report.js', encoded('report-script'));
    files.set('/web/report.css', encoded('report-style'));
    files.set('/web/report.sum', bytesOf(text('report-sum')));
    const module = await inflated(text('engine'));
    const parts = { script: `${text('glue')}\n${text('worker')}`, module, files };
    const run = new Run(
      parts,
      { call: 'run', args: [this.ran.text] },
      (data) => this.begun(data),
      (moment) => this.moment(moment),
    );
    this.run = run;
    this.bar.value = 0;
    this.buttons();
    let report = '';
    try {
      const end = await run.done;
      report = end.report;
      this.status.textContent = end.fault
        ? end.fault.message
        : t('By the run: {1}', (JSON.parse(end.summary) as { verdict: string }).verdict);
    } catch (why) {
      this.status.textContent = why instanceof Stopped ? this.stopped() : messageOf(why);
      this.stopButton.disabled = true;
      if (run.kept.size) report = await unfinished({ ...parts, files: new Map([...files, ...run.kept]) });
    }
    if (report) {
      this.frame.hidden = false;
      this.frame.srcdoc = report;
    }
    this.run = null;
    this.buttons(!!report);
  }

  /** What there is to say of a run that was stopped. */
  private stopped(): string {
    const { last, most } = this;
    if (!last || !most) return t('Stopped before anything was computed.');
    return t(
      'Stopped at {1} s of {2} s. Until then the winch pulled {3} at most, at {4} s. The report is of what was computed until then: it is no verdict of the whole pull.',
      last.time.toFixed(2),
      last.end.toFixed(0),
      this.desk.force(most.force),
      most.time.toFixed(2),
    );
  }

  /** The scene is known: the page of the run goes up, and takes what comes from then on. */
  private begun(data: string): void {
    const run = this.run;
    this.frame.onload = () => {
      this.frame.onload = null;
      const shown: ShowsRuns | null = this.frame.contentWindow;
      const root = shown?.document.getElementById('live');
      const dark = matchMedia('(prefers-color-scheme: dark)').matches;
      if (run !== this.run || !root || !shown?.hawserLive) return;
      const made = shown.hawserLive(
        root,
        JSON.parse(data) as ReportData,
        this.desk.us() ? 'us' : 'si',
        dark ? 'dark' : 'light',
      );
      this.shows = made;
      if (this.last) made.add(this.last);
    };
    this.frame.hidden = false;
    this.frame.srcdoc = livePage();
  }

  private moment(moment: Moment): void {
    const { force } = this.desk;
    const done = moment.end > 0 ? Math.min(1, moment.time / moment.end) : 0;
    // a finer pass begins again
    if (!this.most || moment.time < (this.last?.time ?? 0) || moment.force > this.most.force) this.most = moment;
    this.last = moment;
    this.bar.value = done;
    this.opener.textContent = t('Simulating {1} %', String(Math.floor(100 * done)));
    const pass = moment.pass > 1 ? `${t('Finer settings, pass {1}:', String(moment.pass))} ` : '';
    const so = t(
      '{1} s of {2} s, {3} at the winch',
      moment.time.toFixed(2),
      moment.end.toFixed(0),
      force(moment.force),
    );
    this.status.textContent = `${pass}${so}${moment.heldUp ? `. ${moment.heldUp}` : ''}`;
    this.shows?.add(moment);
  }
}
