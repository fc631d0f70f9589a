// How icons are presented (H04): as a study has fixed it for this session, else as one likes it in this browser.
import { desk } from '../link/desk.svelte'
import { look, type Presentation } from '../state/look.svelte'

export const PRESENTATIONS: readonly Presentation[] = ['pictures', 'both', 'words']

/** The one that the session is held to; undefined: everybody chooses. */
export const fixedPresentation = (): Presentation | undefined =>
  PRESENTATIONS.find((presentation) => presentation === desk.live.preferences.presentation)

export const presentation = (): Presentation => fixedPresentation() ?? look.presentation

/** Whether nobody can see a picture in this session, so that there is none to draw either. */
export const isHeldToWords = (): boolean => fixedPresentation() === 'words'

/** Whether icons are rectangles with words: no pictures, and edges without colour and shape, as in the dissertation (§6.2.1). */
export const isWordsOnly = (): boolean => presentation() === 'words'

/** The picture of an icon beside the row, by its key, as in a run; empty where there is none, or words alone are shown. */
export const signOf = (key: string | undefined): string => (isWordsOnly() ? '' : (desk.tree.pictures[key ?? ''] ?? ''))
