// What an icon is called in words: its description in the language of the page, else its own, else its name.
import { look } from '../state/look.svelte'

interface Described {
  readonly description?: string
  readonly words?: Record<string, string>
}

export function wordsOf(onikon: Described, name: string, language: string = look.language): string {
  return onikon.words?.[language] || onikon.description || name
}
