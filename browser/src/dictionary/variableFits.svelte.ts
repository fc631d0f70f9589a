// Which targets a state variable makes as it is now: the kinds, and the datum of a kind into which its values go (C30).
import type { TargetFitsView, TargetFitView, TypeView } from '../api.gen'
import { say } from '../texts/say'
import { t } from '../texts/index.svelte'
import { Sending } from './form.svelte'

export class VariableFits {
  readonly sending = new Sending()
  view: TargetFitsView | undefined = $state.raw()
  /** The datum chosen where a kind has several that would take it. */
  item = $state('')

  /** Ask for what a variable holds now. */
  async ask(variable: string, place: { doc?: string; subsystem?: string }): Promise<boolean> {
    const view = await this.sending.send({ t: 'FitTargets', variable, ...place })
    if (view) this.view = view as TargetFitsView
    return Boolean(view)
  }

  /** Of these kinds those that take it; all, where nothing of the sort was asked. */
  among(types: [string, TypeView][]): [string, TypeView][] {
    const { view } = this
    return view ? types.filter(([type]) => view.fits.some((fit) => fit.type === type)) : types
  }

  /** The data of a kind that take it. */
  of(type: string): readonly TargetFitView[] {
    return this.view?.fits.filter((fit) => fit.type === type) ?? []
  }

  /** The one into which its values go. */
  chosen(type: string): TargetFitView | undefined {
    const fits = this.of(type)
    return fits.find((fit) => fit.item === this.item) ?? fits[0]
  }

  /** Of these kinds the one in which least is left to be typed. */
  nearest(types: readonly [string, TypeView][]): string {
    const left = ([type, { items }]: [string, TypeView]): number =>
      (items ?? []).reduce((sum, item) => sum + item.count, 0) - (this.chosen(type)?.values.length ?? 0)
    return [...types].sort((a, b) => left(a) - left(b))[0]?.[0] ?? ''
  }

  get source(): string {
    return this.view ? t('target.took', { source: say(this.view.source) }) : ''
  }
}
