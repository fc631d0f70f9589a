// The text of a name in the language of this browser; read inside a template, it follows a change of language.
import { look } from '../state/look.svelte'
import { en, type TextKey } from './en'
import { translationTo } from './translations.svelte'

export type { TextKey }
export type Values = Record<string, string | number>

/** `{name}` stands for a value; `one|many` is chosen by the value `n`. */
export function t(key: TextKey, values: Values = {}): string {
  return fill((translationTo(look.language)?.texts ?? en)[key], values)
}

export function fill(text: string, values: Values): string {
  const forms = text.split('|')
  const form = 'n' in values && forms.length === 2 ? forms[values.n === 1 ? 0 : 1]! : text
  return partsOf(form)
    .map((part, k) => (k % 2 ? String(values[part] ?? `{${part}}`) : part))
    .join('')
}

const taken = new Map<string, readonly string[]>()

/** A text taken apart at its values, once: what is said of a thousand icons is said by few texts. */
function partsOf(form: string): readonly string[] {
  let parts = taken.get(form)
  if (!parts) taken.set(form, (parts = form.split(/\{(\w+)\}/)))
  return parts
}
