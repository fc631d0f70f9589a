// How the page looks in this browser: which level, in which colours, language and sizes.
import { kept } from './kept'

export type Theme = 'auto' | 'light' | 'dark' | '1994' | 'monochrome'
/** As they are offered, and as one command goes through them. */
export const THEMES: readonly Theme[] = ['auto', 'light', 'dark', '1994', 'monochrome']
export type Language = 'en' | 'es'
/** The lower level, where tasks are connected, and the upper one, where pictures are joined. */
export type Level = 'tasks' | 'applications'
/** The parts of a level side by side, as they stand on a wide page; a narrow one shows one of them at a time. */
export type Column = 'left' | 'desk' | 'right' | 'low'
/** Where what has no size of its own stands: above or below the parts of a level, beside or beneath them. */
export interface Stands {
  /** The bar with the tabs, the runtime and Stop. */
  bar: 'above' | 'below'
  /** A user's own buttons: at the foot of the left column, or in a line beneath everything. */
  buttons: 'beside' | 'beneath'
  /** The table of variables: in turn with that of the tasks, or beside it. */
  variables: 'together' | 'beside'
}
export type Presentation = 'pictures' | 'both' | 'words'

interface Look {
  level: Level
  /** Which part a narrow page shows. */
  column: Column
  /** Whether the lower level is hidden. */
  isUpperOnly: boolean
  /** Whether nothing can be changed: a recorded run is shown that stands in a file, without an environment. */
  isFixed: boolean
  /** Whether the tables of what runs stand beneath the upper level too. */
  isInside: boolean
  /** How the dictionary shows its icons. */
  presentation: Presentation
  theme: Theme
  language: Language
  sounds: boolean
  /** Which columns at the sides of a wide page are folded away. */
  folded: { left: boolean; right: boolean }
  sizes: { library: number; sheet: number; strip: number }
  /** The same for the upper level. */
  upperSizes: { dictionary: number; run: number; words: number }
  stands: Stands
}

const language: Language = globalThis.navigator?.language?.startsWith('es') ? 'es' : 'en'

export const look: Look = $state({
  level: kept<Level>('level', 'tasks'),
  column: 'desk',
  isUpperOnly: kept('isUpperOnly', false),
  isFixed: false,
  isInside: false,
  presentation: kept<Presentation>('presentation', 'both'),
  theme: kept<Theme>('theme', 'auto'),
  language: kept<Language>('language', language),
  sounds: kept('sounds', true),
  folded: kept('folded', { left: false, right: false }),
  sizes: kept('sizes', { library: 236, sheet: 286, strip: 206 }),
  upperSizes: kept('upperSizes', { dictionary: 252, run: 330, words: 138 }),
  stands: kept<Stands>('stands', { bar: 'above', buttons: 'beside', variables: 'together' }),
})
