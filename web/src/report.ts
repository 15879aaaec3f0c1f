// The report in a frame of the page, whose policy holds there, too: it allows a style element that has the page's nonce,
// and no style attribute.

/** The report with its own style named to the policy, and its style attributes as rules of such a style. Markup of the
    report alone has a `<`: what comes from a deck is escaped. */
export function underPolicy(nonce: string, html: string): string {
  const rules: string[] = [];
  const plain = html.replace(/(<[a-z]+(?: [^<>]*?)?) style="([^"<>{}]*)"/g, (_, tag: string, css: string) => {
    rules.push(`[data-rule="${rules.length}"]{${css}}`);
    return `${tag} data-rule="${rules.length - 1}"`;
  });
  const own = rules.length > 0 ? `<style nonce="${nonce}">${rules.join('')}</style></head>` : '</head>';
  return plain.replace('<style>', () => `<style nonce="${nonce}">`).replace('</head>', () => own);
}
