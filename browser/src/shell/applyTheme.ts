// The ground the page is drawn on: as the system has it, light, dark, in the colours of the dissertation, or without any.
import type { Theme } from '../state/look.svelte'

const CLASSES: Record<Theme, string[]> = {
  auto: [],
  light: ['light'],
  dark: ['dark'],
  '1994': ['light', 'y1994'],
  monochrome: ['light', 'monochrome'],
}

export function applyTheme(theme: Theme, root: Pick<Element, 'classList'> = document.documentElement): void {
  root.classList.remove(...Object.values(CLASSES).flat())
  root.classList.add(...CLASSES[theme])
}
