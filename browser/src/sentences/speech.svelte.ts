// Reading sentences aloud, one after the other, where the browser can speak.

class Speech {
  /** The place of the sentence that is read now; -1: silence. */
  at = $state(-1)
  private turn = 0

  get isThere(): boolean {
    return typeof speechSynthesis !== 'undefined' && typeof SpeechSynthesisUtterance !== 'undefined'
  }

  /** Read these texts in a language. */
  begin(texts: readonly string[], language: string): void {
    this.stop()
    this.read(texts, language, 0, this.turn)
  }

  stop(): void {
    this.turn += 1
    this.at = -1
    if (this.isThere) speechSynthesis.cancel()
  }

  private read(texts: readonly string[], language: string, at: number, turn: number): void {
    const text = texts[at]
    if (turn !== this.turn) return
    if (text === undefined) {
      this.at = -1
      return
    }
    this.at = at
    const words = new SpeechSynthesisUtterance(text)
    words.lang = language
    words.onend = () => this.read(texts, language, at + 1, turn)
    words.onerror = () => {
      if (turn === this.turn) this.stop()
    }
    speechSynthesis.speak(words)
  }
}

export const speech = new Speech()
