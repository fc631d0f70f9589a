// What was typed into a form that was put aside without being sent: it stands there again when the form is opened anew.

/** By form, then by the name of a field. */
const aside = new Map<string, ReadonlyMap<string, string>>()

type TextField = HTMLInputElement | HTMLTextAreaElement

const FIELDS = 'input:is([type=text], [type=search], [type=url], [type=number], :not([type])), textarea'

const nameOf = (field: TextField): string =>
  field.labels?.[0]?.textContent?.trim() || field.getAttribute('aria-label') || field.id || field.name

function fieldsOf(root: HTMLElement): TextField[] {
  const forms = root.matches('form') ? [root] : [...root.querySelectorAll('form')]
  return forms.flatMap((form) => [...form.querySelectorAll<TextField>(FIELDS)])
}

/** Follows what is typed into the forms within an element; `form` names them from one time to the next. */
export class TypedText {
  private readonly typed = new Map<string, string>()

  constructor(
    private readonly root: HTMLElement,
    private readonly form: string,
  ) {
    root.addEventListener('input', (event) => this.take(event))
    this.restore()
  }

  /** It is closed by hand, and not because it was sent or cancelled. */
  putAside(): void {
    if (this.typed.size) aside.set(this.form, new Map(this.typed))
  }

  private take(event: Event): void {
    const field = event.target
    if (!(field instanceof HTMLElement) || !fieldsOf(this.root).includes(field as TextField)) return
    this.typed.set(nameOf(field as TextField), (field as TextField).value)
  }

  private restore(): void {
    const before = aside.get(this.form)
    aside.delete(this.form)
    if (!before) return
    for (const field of fieldsOf(this.root)) {
      const text = before.get(nameOf(field))
      if (text === undefined || field.readOnly || field.disabled) continue
      field.value = text
      field.dispatchEvent(new Event('input', { bubbles: true }))
    }
  }
}
