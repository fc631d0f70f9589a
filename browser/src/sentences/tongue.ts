// The words between the descriptions, in each language of this page.
import { en } from '../texts/en'
import { es } from '../texts/es'
import type { Language } from '../state/look.svelte'
import type { Tongue } from './sentences'

const CATALOGUES = { en, es }

export const TONGUES: Readonly<Record<Language, string>> = { en: 'English', es: 'Español' }

export const tongueOf = (code: Language): Tongue => ({ code, say: (key) => CATALOGUES[code][key] })
