// What the actions of the application that runs are about, told once for all who show it.
import { desk } from '../link/desk.svelte'
import { look } from '../state/look.svelte'
import { briefs } from './sentences'
import { connectivesOf } from './connectives'

class ActionTexts {
  private readonly all = $derived.by(() => {
    const app = desk.tree.applications[desk.tree.run?.doc ?? '']
    return app ? briefs(app, desk.tree.types, connectivesOf(look.language)) : new Map<number, string>()
  })

  of(step: number): string {
    return this.all.get(step) ?? ''
  }
}

export const actionTexts = new ActionTexts()
