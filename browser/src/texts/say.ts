// A reason in the language of who reads it, as `in_language` of src/onika/words/reason.py says it.
import { look } from '../state/look.svelte'
import { fill, type Value } from './sentence'
import { translationTo } from './translations.svelte'

/** What a reason carries; `text` is its English sentence. */
export interface Reason {
  readonly key: string
  readonly text: string
  readonly args?: Readonly<Record<string, Value<Reason>>>
}

type Catalogue = Readonly<Record<string, string>>

/** What modules say: translations by module, language and sentence. */
export type ModuleSentences = Readonly<Record<string, Readonly<Record<string, Catalogue>>>>

const OF_MODULE = 'module:'
const PLAIN = 'plain'

/** Where the translations of modules are: whoever holds what the environment shows sets it. */
export const modules: { sentences: () => ModuleSentences } = { sentences: () => ({}) }

/** A text that is in no catalogue of the environment: the page's own words, or what nobody translates. */
export const plain = (text: string): Reason => ({ key: PLAIN, text })

/** The sentence of a reason in the language of the page, or its English where that language does not have it whole;
 *  nothing where there is no reason. Names stand in it without the marks with which terminals show them. */
export function say(reason: Reason | undefined, language: string = look.language): string {
  if (!reason) return ''
  return sentence(reason, language).replaceAll('`', '')
}

function sentence(reason: Reason, language: string): string {
  const isOfModule = reason.key.startsWith(OF_MODULE)
  const translation = isOfModule
    ? ofModule(reason.key, language)
    : entry(translationTo(language)?.sentences, reason.key)
  if (translation === undefined) return reason.text
  if (isOfModule && !reason.args) return translation
  try {
    return fill(translation, reason.args ?? {}, language, (inner: Reason) => sentence(inner, language))
  } catch (wrong) {
    if (wrong instanceof RangeError) return reason.text
    throw wrong
  }
}

/** The translation of a module's sentence, whose key is `module:NAME:SENTENCE`. */
function ofModule(key: string, language: string): string | undefined {
  const end = key.indexOf(':', OF_MODULE.length)
  return entry(modules.sentences()[key.slice(OF_MODULE.length, end)]?.[language], key.slice(end + 1))
}

/** What a module says of one of its inputs, in the language of the page: the first module that has a translation gives it. */
export function meaningOf(text: string, language: string = look.language): string {
  const translations = Object.values(modules.sentences()).map((sentences) => entry(sentences[language], text))
  return translations.find((translation) => translation !== undefined) ?? text
}

function entry(catalogue: Catalogue | undefined, key: string): string | undefined {
  return catalogue && Object.hasOwn(catalogue, key) ? catalogue[key] : undefined
}

/** A reason, then those that fill its gaps, and theirs. */
export function every(reason: Reason): Reason[] {
  const values = Object.values(reason.args ?? {}).flat() as Value<Reason>[]
  return [reason, ...values.flatMap((value) => (typeof value === 'object' ? every(value as Reason) : []))]
}

/** Whether a reason is another one, or has it within; a text of nobody's catalogue may stand there bare. */
export function contains(whole: Reason, part: Reason): boolean {
  const isPlain = part.key === PLAIN
  return every(whole).some(
    (reason) =>
      (reason.text === part.text && (isPlain || reason.key === part.key)) ||
      (isPlain && Object.values(reason.args ?? {}).includes(part.text)),
  )
}
