// What the environment says, in the language of this browser as far as that is known here; else as it was said.
import { look, type Language } from '../state/look.svelte'
import { esHeard } from './es.heard'

type Sayings = readonly (readonly [RegExp, string])[]
const SAYINGS: Partial<Record<Language, Sayings>> = { es: esHeard }

export function heard(text: string, language: Language = look.language): string {
  for (const [said, words] of SAYINGS[language] ?? []) {
    const found = said.exec(text)
    if (found)
      return words.replace(/\{(=?)(\d)\}/g, (_, again: string, k: string) =>
        again ? heard(found[Number(k) + 1] ?? '', language) : (found[Number(k) + 1] ?? ''),
      )
  }
  return text
}
