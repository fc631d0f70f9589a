// A Stop that was asked and is not answered yet: for how long, and whether it still waits for the way to the environment.

/** After so many seconds without an answer it is said aloud. */
export const LATE_S = 1

export class StopRequest {
  /** Whole seconds since it was asked; 0 where none is asked. */
  seconds = $state(0)
  /** Whether it could not be sent yet: it goes out as soon as the environment is there again. */
  isUnsent = $state(false)
  private since = 0
  private open = 0
  private beat: ReturnType<typeof setInterval> | undefined

  /** Whether somebody has waited for an answer too long. */
  get isLate(): boolean {
    return this.seconds >= LATE_S
  }

  /** One was asked; `answered` ends it. Those that are asked meanwhile count from the first. */
  begin(): void {
    this.open++
    if (this.beat !== undefined) return
    this.since = Date.now()
    this.beat = setInterval(() => (this.seconds = Math.floor((Date.now() - this.since) / 1000)), 250)
  }

  /** An answer has come: to whichever of them, for one that was heard is enough. */
  answered(): void {
    this.open = 0
    this.isUnsent = false
    this.seconds = 0
    clearInterval(this.beat)
    this.beat = undefined
  }

  /** One of them will not be answered any more. */
  failed(): void {
    if (this.open > 0) this.open--
    if (this.open === 0) this.answered()
  }
}

export const stopRequest = new StopRequest()
