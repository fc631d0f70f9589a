// What the environment says, in the language of this browser as far as that is known here; else as it was said.
import { look, type Language } from '../state/look.svelte'
import { esHeard } from './es.heard'
import { say, type Reason } from './say'

type Sayings = readonly (readonly [RegExp, string])[]
const SAYINGS: Partial<Record<Language, Sayings>> = { es: esHeard }

export function heard(text: Reason | string, language: Language = look.language): string {
  if (typeof text !== 'string') return say(text, language)
  for (const [pattern, words] of SAYINGS[language] ?? []) {
    const match = pattern.exec(text)
    if (match)
      return words.replace(/\{(=?)(\d)\}/g, (_, again: string, k: string) =>
        again ? heard(match[Number(k) + 1] ?? '', language) : (match[Number(k) + 1] ?? ''),
      )
  }
  return text
}
