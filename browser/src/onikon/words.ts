// What an icon is called in words: its description in the language of the page, else its own, else its name.
import { here } from '../state/here.svelte'

interface Described {
  readonly description?: string
  readonly words?: Record<string, string>
}

export function wordsOf(one: Described, name: string, language: string = here.language): string {
  return one.words?.[language] || one.description || name
}
