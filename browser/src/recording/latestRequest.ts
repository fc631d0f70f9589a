// Questions that follow a hand: one with each picture of the screen at most, never two on their way, the newest wish wins.

export class LatestRequest<Answer> {
  private wanted: number | undefined
  private isOut = false
  private isDue = false
  private turn = 0

  /** `soon` runs something with the next picture of the screen; `lost` hears why no answer came. */
  constructor(
    private readonly ask: (at_s: number) => Promise<Answer>,
    private readonly take: (answer: Answer, at_s: number) => void,
    private readonly lost: (why: unknown) => void,
    private readonly soon: (run: () => void) => void,
  ) {}

  want(at_s: number): void {
    this.wanted = at_s
    if (this.isOut || this.isDue) return
    this.isDue = true
    this.soon(() => void this.go())
  }

  /** What is on its way is not taken any more. */
  forget(): void {
    this.wanted = undefined
    this.turn += 1
  }

  private async go(): Promise<void> {
    this.isDue = false
    const at_s = this.wanted
    if (at_s === undefined) return
    this.wanted = undefined
    this.isOut = true
    const turn = this.turn
    try {
      const answer = await this.ask(at_s)
      if (turn === this.turn) this.take(answer, at_s)
    } catch (why) {
      if (turn === this.turn) this.lost(why)
    } finally {
      this.isOut = false
      if (this.wanted !== undefined) this.want(this.wanted)
    }
  }
}
