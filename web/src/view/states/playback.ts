// The clock of the playback: simulated time against real time.

export const RATES = [0.1, 0.25, 0.5, 1, 2, 5, 10, 20, 50, 100, 200, 500, 1000];

/** Real time in which a whole pull passes at the first choice of the rate, s. */
const WHOLE_S = 25;

/** The rate at which `duration` of simulated time takes about WHOLE_S; real time if it is shorter. */
export const usualRate = (duration: number): number =>
  RATES.find((rate) => rate >= 1 && duration / rate <= WHOLE_S * 1.2) ?? RATES[RATES.length - 1]!;

export class Playback {
  playing = false;
  rate: number;
  time: number;

  constructor(
    readonly from: number,
    public to: number,
  ) {
    this.time = from;
    this.rate = usualRate(to - from);
  }

  seek(time: number): void {
    this.time = Math.min(this.to, Math.max(this.from, time));
  }

  /** Plays on, from the start if it had come to the end; or pauses. */
  toggle(): void {
    this.playing = !this.playing;
    if (this.playing && this.time >= this.to) this.time = this.from;
  }

  /** Real time goes on by `elapsed` s; at the end it stops. Returns whether the simulated time has changed. */
  advance(elapsed: number): boolean {
    if (!this.playing) return false;
    this.seek(this.time + this.rate * Math.min(elapsed, 0.25));
    if (this.time >= this.to) this.playing = false;
    return true;
  }
}
