// What outlives the page: how it looks, and which library and dictionary are shown.
import { canvas } from './canvas.svelte'
import { keep } from './kept'
import { look } from './look.svelte'
import { workspace } from './workspace.svelte'

/** Remember it from now on. Call it once, inside an effect root. */
export function remember(): void {
  $effect(() => keep('theme', look.theme))
  $effect(() => keep('language', look.language))
  $effect(() => keep('sounds', look.sounds))
  $effect(() => keep('level', look.level))
  $effect(() => keep('isUpperOnly', look.isUpperOnly))
  $effect(() => keep('presentation', look.presentation))
  $effect(() => keep('folded', $state.snapshot(look.folded)))
  $effect(() => keep('sizes', $state.snapshot(look.sizes)))
  $effect(() => keep('upperSizes', $state.snapshot(look.upperSizes)))
  $effect(() => keep('stands', $state.snapshot(look.stands)))
  $effect(() => keep('dictionary', workspace.dictionary))
  $effect(() => keep('library', canvas.library))
}
