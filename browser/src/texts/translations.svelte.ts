// What the page says in other languages than English; fetched when somebody reads one of them, and English until then.
import { look, type Language } from '../state/look.svelte'
import type { TextKey } from './en'

interface Translation {
  /** The page's own texts. */
  readonly texts: Readonly<Record<TextKey, string>>
  /** The sentences of reasons, by their keys. */
  readonly sentences: Readonly<Record<string, string>>
}

const FETCH: Partial<Record<Language, () => Promise<Translation>>> = { es: () => import('./es') }

let fetched: Readonly<Partial<Record<string, Translation>>> = $state.raw({})

export const translationTo = (language: string): Translation | undefined => fetched[language]

/** Have the translation of a language, if it can be fetched; it may be asked for as often as one likes. */
export async function fetchTranslation(language: Language = look.language): Promise<void> {
  const found = await FETCH[language]?.().catch(() => undefined) // the link is gone, which is told elsewhere
  if (found && !fetched[language]) fetched = { ...fetched, [language]: found }
}
