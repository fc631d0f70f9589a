// Choosing where a flow shall go: while it is on, a click on an icon sends its flow there (E13).
import { act } from '../act/act'
import { desk } from '../link/desk.svelte'
import { workspace } from '../state/workspace.svelte'

class SkipMode {
  isOn = $state(false)

  begin(): void {
    const doc = desk.tree.run?.doc ?? ''
    if (desk.tree.applications[doc]) workspace.app = doc // its icons are what is clicked
    this.isOn = true
  }

  end(): void {
    this.isOn = false
  }

  turn(): void {
    if (this.isOn) this.end()
    else this.begin()
  }

  /** This is the step; its flow goes there at once. */
  async choose(step: number): Promise<void> {
    this.isOn = false
    await act({ t: 'SkipTo', step, doc: desk.live.run?.doc ?? '' })
  }
}

export const skipMode = new SkipMode()
