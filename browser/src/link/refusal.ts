// An act that changed nothing: why, and what could be done instead, in the language of who reads it.
import type { Refused, Remedy } from '../api.gen'
import { say, type Reason } from '../texts/say'

export class Refusal extends Error {
  readonly remedies: readonly Remedy[]
  private readonly why: Reason
  private readonly wrong: Readonly<Record<string, Reason>>

  constructor(why: Reason, remedies: readonly Remedy[] = [], wrong: Readonly<Record<string, Reason>> = {}) {
    super(why.text)
    this.name = 'Refusal'
    this.why = why
    this.remedies = remedies
    this.wrong = wrong
  }

  /** Which sentence it is, in every language. */
  get key(): string {
    return this.why.key
  }

  get reason(): string {
    return say(this.why)
  }

  /** Of forms: what is wrong with each field. */
  get fields(): Readonly<Record<string, string>> {
    return Object.fromEntries(Object.entries(this.wrong).map(([field, why]) => [field, say(why)]))
  }

  /** What a field holds as it is: a file, not a sentence. */
  textOf(field: string): string | undefined {
    return this.wrong[field]?.text
  }

  static from(answer: Refused): Refusal {
    return new Refusal(answer.reason, answer.remedies, answer.fields)
  }
}
