// Text in parts, so that names and marks in it can be drawn apart.

export interface Part {
  text: string
  kind?: 'target' | 'mark' | 'fault'
}

export const glue = (text: string): Part[] => (text ? [{ text }] : [])
export const plain = (parts: readonly Part[]): string => parts.map((part) => part.text).join('')

/** A template with `{name}` where parts stand in for text. */
export function compose(template: string, values: Readonly<Record<string, readonly Part[]>>): Part[] {
  return template.split(/(\{\w+\})/).flatMap((piece) => {
    const name = /^\{(\w+)\}$/.exec(piece)?.[1]
    return name === undefined ? glue(piece) : (values[name] ?? glue(piece))
  })
}
