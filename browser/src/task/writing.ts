// Values that are written by hand: while somebody drags, the newest is sent, one at a time and not too often.
export class Writer {
  private next: number[] | undefined
  private isBusy = false

  /** `write` sends values; `pause` waits between two of them. */
  constructor(
    private readonly write: (values: number[]) => Promise<void>,
    private readonly pause: () => Promise<void>,
  ) {}

  /** What was not sent yet is forgotten for newer values; the newest are always sent. */
  put(values: readonly number[]): void {
    this.next = [...values]
    if (!this.isBusy) void this.go()
  }

  private async go(): Promise<void> {
    this.isBusy = true
    while (this.next) {
      const values = this.next
      this.next = undefined
      await this.write(values)
      await this.pause()
    }
    this.isBusy = false
  }
}

/** Numbers with other words for one of them; undefined where the word is none. */
export function withWord(values: readonly number[], k: number, word: string): number[] | undefined {
  const value = Number(word.trim().replace('−', '-').replace(',', '.'))
  if (!word.trim() || !Number.isFinite(value)) return undefined
  return values.map((other, n) => (n === k ? value : other))
}
