// The words between the descriptions, in each language of this page.
import { en } from '../texts/en'
import { es } from '../texts/es'
import type { Language } from '../state/look.svelte'
import type { Connectives } from './tale'

const CATALOGUES = { en, es }

export const LANGUAGES: Readonly<Record<Language, string>> = { en: 'English', es: 'Español' }

export const connectivesOf = (code: Language): Connectives => ({ code, say: (key) => CATALOGUES[code][key] })
