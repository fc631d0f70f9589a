// An act that changed nothing: why, and what could be done instead.
import type { Refused, Remedy } from '../api.gen'

export class Refusal extends Error {
  readonly reason: string
  readonly remedies: readonly Remedy[]
  /** Of forms: what is wrong with each field. */
  readonly fields: Readonly<Record<string, string>>

  constructor(reason: string, remedies: readonly Remedy[] = [], fields: Readonly<Record<string, string>> = {}) {
    super(reason)
    this.name = 'Refusal'
    this.reason = reason
    this.remedies = remedies
    this.fields = fields
  }

  static from(answer: Refused): Refusal {
    return new Refusal(answer.reason, answer.remedies, answer.fields)
  }
}
