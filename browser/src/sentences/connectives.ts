// The words between the descriptions, in each language of this page.
import { en } from '../texts/en'
import { translationTo } from '../texts/translations.svelte'
import type { Language } from '../state/look.svelte'
import type { Connectives } from './tale'

export const LANGUAGES: Readonly<Record<Language, string>> = { en: 'English', es: 'Español' }

export const connectivesOf = (code: Language): Connectives => ({
  code,
  say: (key) => (translationTo(code)?.texts ?? en)[key],
})
