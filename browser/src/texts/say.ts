// A reason in the language of who reads it, as `in_language` of src/onika/words/reason.py says it.
import { catalogue as es } from './catalogue.es.gen'
import { fill, type Value } from './sentence'

/** What a reason carries; `text` is its English sentence. */
export interface Reason {
  readonly key: string
  readonly text: string
  readonly args?: Readonly<Record<string, Value<Reason>>>
}

const CATALOGUES: Readonly<Record<string, Readonly<Record<string, string>>>> = { es }

/** The sentence of a reason, or its English where that language does not have it whole; a bare text is as it is. */
export function say(reason: Reason | string, language: string): string {
  if (typeof reason === 'string') return reason
  const catalogue = CATALOGUES[language]
  if (!catalogue || !Object.hasOwn(catalogue, reason.key)) return reason.text
  try {
    return fill(catalogue[reason.key]!, reason.args ?? {}, language, (inner: Reason) => say(inner, language))
  } catch (wrong) {
    if (wrong instanceof RangeError) return reason.text
    throw wrong
  }
}
