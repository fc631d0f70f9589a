// The ground the page is drawn on: as the system has it, light, dark, or in the colours of the dissertation.
import type { Theme } from '../state/look.svelte'

const CLASSES: Record<Theme, string[]> = { auto: [], light: ['light'], dark: ['dark'], '1994': ['light', 'y1994'] }

export function applyTheme(theme: Theme, root: Pick<Element, 'classList'> = document.documentElement): void {
  root.classList.remove('light', 'dark', 'y1994')
  root.classList.add(...CLASSES[theme])
}
